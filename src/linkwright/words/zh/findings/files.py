"""Problems of files and their text."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "file.unreadable": (
        "无法读取文件 {file}：{reason}。",
        "检查文件名以及读取权限。",
    ),
    "file.irregular": (
        "{file} 是{kind}；只能读取普通文件。",
        "给出普通文件的名称，或指向普通文件的链接。",
    ),
    "file.not-found": (
        "文件 {file} 不存在。",
        "{hint}",
    ),
    "file.unwritable": (
        "无法写入 {file}：{reason}。",
        "用 --out 指定其他文件夹，或开放该文件夹的写入权限。",
    ),
    "file.package-fails": (
        "无法加载软件包 {package}：{reason}",
        "若该信息与主目录有关，将环境变量 HOME 设为已有的文件夹；否则重新安装该软件包。",
    ),
    "file.no-temporary": (
        "没有可用的临时文件夹：{reason}。",
        "指定一个可写入的文件夹：TMPDIR=FOLDER linkwright ...（Windows 下为 TEMP）。",
    ),
    "file.needs-package": (
        "此功能需要软件包 {package}，但尚未安装。",
        '用以下命令安装：pip install "linkwright[{extra}]"。',
    ),
    "file.unwritten": (
        "未安装软件包 {package}，因此没有写出：{files}。",
        '用以下命令安装：pip install "linkwright[{extra}]"；在仓库的克隆中，用虚拟环境（.venv）的 Python 运行'
        ' python -m pip install -e ".[{extra}]"。',
    ),
    "file.too-large": (
        "文件大小超过 {limit} 字节，即模型文件的上限。",
        "将较长的表存为 CSV 文件，放在模型文件旁，并在 tables 中引用。",
    ),
    "file.binary": (
        "文件不是有效的 UTF-8 文本（第 {at} 字节）；它可能是二进制文件，或采用了 GBK 等其他编码。",
        "将模型存为 UTF-8 编码的纯文本。",
    ),
    "file.encoding": (
        "文件不是有效的 UTF-8 文本（第 {at} 字节）；其编码可能是 {encoding}。",
        "将其存为 UTF-8 编码：在记事本和多数编辑器中，通过“另存为”的“编码”选项设置。",
    ),
    "file.read-as": (
        "文件不是 UTF-8 编码，按 {encoding} 读取。",
        "将其存为 UTF-8 编码：在记事本和多数编辑器中，通过“另存为”的“编码”选项设置。若结果中的名称显示为乱码，则文件采用的是其他编码。",
    ),
    "file.wide": (
        "文件中应为半角字符之处使用了全角字符：{given}",
        "{hint}",
    ),
    "file.blank": (
        "该行含有全角空格或不间断空格（显示为 ␣）：{given}",
        "{hint}",
    ),
    "file.brackets": (
        "列表应使用方括号：{given}",
        "改写为 {meant}。",
    ),
    "file.colon": (
        "冒号之后缺少空格：{given}",
        "{hint}",
    ),
    "file.equals": (
        "键与值之间应使用冒号，不能用“=”：{given}",
        "{hint}",
    ),
    "file.decimal-comma": (
        "YAML 会在逗号处拆分“{text}”；小数点应为“.”。",
        "改写为 {meant}。",
    ),
    "file.character": (
        "文本中含有控制字符。",
        "重新输入该文本，不使用 \\x、\\u 或 \\0 转义。",
    ),
    "file.empty": (
        "文件为空。",
        "首行写“linkwright: 1”，然后添加构件和驱动；见 docs/file-format.md。",
    ),
    "file.documents": (
        "此处开始第二个 YAML 文档（在“---”或“...”之后）；一个模型文件只能含一个文档。",
        "删除该标记，或将文件拆分。",
    ),
    "file.mapping": (
        "文件顶层没有“key: value”形式的条目。",
        "首行写“linkwright: 1”，然后添加构件和驱动；见 docs/file-format.md。",
    ),
    "file.version": (
        "文件未声明格式版本 {known}（实际为：{given}）。",
        "首行写“linkwright: {known}”。",
    ),
    "file.yaml": (
        "此处不符合 YAML 语法：{reason}。",
        "检查本行和上一行是否有未闭合的括号或引号、缺少的冒号或错误的缩进。",
    ),
    "file.tab": (
        "本行含有制表符；YAML 在此处只允许使用空格。",
        "将制表符改为空格；多数编辑器可设置为按 Tab 键时插入空格。",
    ),
    "file.quote": (
        "以“{value}”开头的值，YAML 无法按文本读取。",
        "将该值加上双引号。",
    ),
    "file.comma": (
        "“{text}”未加引号，YAML 会在逗号处将其拆分。",
        '将表达式加上引号："{text}"。',
    ),
    "file.alias": (
        "“{mark}”是 YAML 的锚点或别名，模型文件不支持。",
        "改用参数；若该值本来就以“*”或“&”开头，将其加上双引号。",
    ),
    "file.tag": (
        "“{tag}”是 YAML 的类型标签，模型文件不支持。",
        "删除该标签；若该值本来就以“!”开头，将其加上双引号。",
    ),
    "file.key": (
        "冒号之前应为名称，此处却是列表或映射。",
        "冒号之前写普通名称；值写在冒号之后的花括号或方括号中。",
    ),
    "file.depth": (
        "值的嵌套超过 {limit} 层。",
        "模型文件最多需要五层：检查是否有多余的括号。",
    ),
    "file.duplicate": (
        "“{name}”在同一位置重复出现，首次出现在第 {first} 行。",
        "将其中一个改名或删除。",
    ),
    "file.too-many": (
        "此处有 {count} 个条目；一个模型文件最多允许 {limit} 个。",
        "拆分模型；将较长的表存为 CSV 文件。",
    ),
    "file.long": (
        "该文本超过 {limit} 个字符。",
        "缩短文本；将长表达式的各部分定义为参数。",
    ),
    "file.more": (
        "至少还有 {count} 个问题。",
        "先修正上述问题；其余问题多数可能由它们引起。",
    ),
    "file.missing": (
        "此处缺少“{name}”。",
        "添加该键。此类条目的键有：{known}。",
    ),
    "file.unknown-key": (
        "未知的键“{name}”。",
        "{near}否则将其删除。",
    ),
    "file.kind": (
        "此处不能写“{name}: {kind}”：条目的类型应作为键写出。",
        "{near}",
    ),
    "file.kinds": (
        "一个条目只能属于一种类型；此处混有多种类型的键：{keys}。",
        "只保留一种类型的键，将另一种写成单独的条目。",
    ),
    "file.expected": (
        "应为：{wanted}；实际为：{given}。",
        "{hint}",
    ),
    "file.not-finite": (
        "{given} 不是有限值。",
        "给出有限的数值。",
    ),
    "file.bad-name": (
        "“{name}”不是有效的名称。",
        "{hint}",
    ),
    "file.reserved-name": (
        "“{name}”是保留名称：t 为时间，pi 为圆周率，start 和 end 为分析时段的起点和终点。",
        "改用其他名称。",
    ),
    "builder.twice": (
        "“{name}”被重复添加到构建器中。",
        "将其中一个改名或删除。",
    ),
    "file.exists": (
        "文件 {file} 已存在。",
        "用 --out 指定其他名称，或添加 --force 覆盖该文件。",
    ),
    "gallery.unknown": (
        "示例库中没有名为“{name}”的模型。",
        "{near}“linkwright new”可列出全部模型。",
    ),
}
