"""Problems of tables."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "table.source": (
        "表必须由文件或数据点之一给出。",
        "给出 file 以及 x 和 y，或给出 points: [[x, y], ...]。",
    ),
    "table.columns": (
        "未指定所用的文件列。",
        "按“列名 单位”的形式添加 x 和 y，例如 x: angle deg。",
    ),
    "table.inline-columns": (
        "{given} 用于指定文件的列，但此处的数据点是直接给出的。",
        "将其删除；在数据点中写明单位，或使用 units 中声明的单位。",
    ),
    "table.place": (
        "文件“{file}”不在模型文件夹中。",
        "将其放入模型文件夹或其子文件夹；文件名中不含“..”，也不含盘符或根目录。",
    ),
    "table.unreadable": (
        "无法读取文件 {file}：{reason}。",
        "将该文件放在模型文件旁，名称须完全一致，并开放读取权限。",
    ),
    "table.too-large": (
        "文件 {file} 超过大小上限 {limit} 字节。",
        "删除多余的行和列；若为图形文件，只保留轨迹。",
    ),
    "table.not-text": (
        "文件 {file} 不是有效的 UTF-8 文本：第 {at} 字节（第 {line} 行）无效。",
        "将其存为 UTF-8 编码的 CSV 文件，不使用 UTF-16、GBK 或电子表格格式。",
    ),
    "table.encoding": (
        "文件 {file} 不是有效的 UTF-8 文本（第 {at} 字节，第 {line} 行）；其编码可能是 {encoding}。",
        "将其存为 UTF-8 编码：在电子表格软件中，“另存为”选择“CSV UTF-8”。",
    ),
    "table.bad-line": (
        "文件 {file} 的第 {line} 行不符合 CSV 格式：{reason}。",
        "检查该行及其上方各行是否有不成对的引号。",
    ),
    "table.empty": (
        "文件 {file} 为空。",
        "首行写列名，以下各行写数值，以逗号分隔。",
    ),
    "table.separator": (
        "文件 {file} 的列分隔符为{sign}，应为半角逗号“,”。",
        "重新保存该文件：以半角逗号分隔各列，数值的小数点用“.”。",
    ),
    "table.column-twice": (
        "文件 {file} 中有多个名为“{name}”的列。",
        "为各列取不同的名称，或删除不需要的列。",
    ),
    "table.no-column": (
        "文件中没有“{name}”列。现有的列：{known}。",
        "改正 x 和 y，或改正文件的首行。",
    ),
    "table.not-number": (
        "文件第 {row} 行“{name}”列的内容为“{given}”，应为绝对值小于 1e40 的有限数值。",
        "改正该单元格；小数点用“.”，不写单位。",
    ),
    "table.long": (
        "文件超过 {limit} 行。",
        "减少行数：各点之间以样条插值，只需少量数据点。",
    ),
    "table.short": (
        "表中有 {given} 个点，其间的曲线至少需要 {wanted} 个点。",
        "增加数据点，或写 between: linear。",
    ),
    "table.order": (
        "x 值必须递增（第 {row} 行）。",
        "对数据点排序，每个 x 值只给出一次。",
    ),
    "table.uneven": (
        "部分点的间距与其他点相比过小，无法用光滑曲线通过这些点。",
        "删除间距过小的点，或写 between: linear。",
    ),
    "table.period": (
        "数据点的跨度超过一个周期。",
        "增大周期，或减少数据点。",
    ),
    "table.not-closed": (
        "数据点正好跨越一个周期，但首末两点的值不相等。",
        "使二者相等，或删除最后一点。",
    ),
}
