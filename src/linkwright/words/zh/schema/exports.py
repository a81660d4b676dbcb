"""Descriptions in the JSON Schema of the options of export targets."""

TEXTS: dict[str, str] = {
    # MuJoCo.
    "schema.MjcfOptions": "MuJoCo 所需而机构中没有的设置。",
    "schema.MjcfOptions.tiny_mass": "无质量构件所用的质量；默认为 1 g",
    "schema.MjcfOptions.timestep": "MuJoCo 的时间步长；默认为 1 ms",
    "schema.MjcfOptions.duration": "运动的时长；默认与运动循环相同",
    "schema.MjcfOptions.samples": "位置表中运动的等分步数",
    # Motors of CAD systems.
    "schema.MotorOptions": "文本的语法格式、时长和步数。",
    "schema.MotorOptions.dialect": "creo：sin、cos 的自变量为度；或 radians：为弧度",
    "schema.MotorOptions.duration": "运动的时长；默认与运动循环相同",
    "schema.MotorOptions.samples": "数值表的等分步数",
    # Process Simulate.
    "schema.ProcessSimulateOptions": "语法格式、范围，以及运动副在 Process Simulate 中的名称。",
    "schema.ProcessSimulateOptions.dialect": "seed（acos、sqrt、sin、cos）或 wizard（acos、sin、atan2）",
    "schema.ProcessSimulateOptions.names": "运动副在 Process Simulate 中的名称；默认与模型相同",
    "schema.ProcessSimulateOptions.master": "作为所有函数自变量的运动副，用模型或 Process Simulate 中的名称；默认为驱动带动的运动副",
    "schema.ProcessSimulateOptions.mirror": "将两个镜像且同步运动的铰链的函数写入同一文件",
    "schema.ProcessSimulateOptions.zero": "所有运动副为 0 的位姿下的驱动数值；默认为起始时的值",
    "schema.ProcessSimulateOptions.range": "驱动数值的范围 [下限, 上限]；默认为从起始处所能达到的全部范围，不到死点",
    "schema.ProcessSimulateOptions.stops": "驱动运动副相对零位的范围 [下限, 上限]，按 Process Simulate 的计数方向，代替 range",
    "schema.ProcessSimulateOptions.flipped": "在 Process Simulate 中反向计数的运动副：轴线反向，父子构件互换",
    "schema.ProcessSimulateOptions.left_out": "Process Simulate 中没有的运动副",
    "schema.ProcessSimulateOptions.decimals": "最少小数位数；精度需要时增加",
    "schema.ProcessSimulateOptions.longest": "文本的最大长度；更长的借助辅助运动副拆分",
    "schema.ProcessSimulateOptions.approximate": "杆组没有封闭解时，多项式的允许误差（rad 或 mm）",
    "schema.ProcessSimulateOptions.sheet": "图表页中除函数外的内容",
    "schema.Mirror": "两个铰链的运动副在 Process Simulate 中的名称和计数方向。",
    "schema.Mirror.suffixes": "第一侧和第二侧运动副名称的后缀；默认为 _l 和 _r",
    "schema.Mirror.prefixes": "第一侧和第二侧运动副名称的前缀",
    "schema.Mirror.signs": "mirrored：第二侧的轴线为第一侧的镜像，因此其转动反向计数，移动同向计数；same：两侧同向计数",
    "schema.Facts": "图表页中除运动副函数外的内容。",
    "schema.Facts.panel": "给出其开启角的构件；默认为 handle 或 outline 所在的构件，否则为连杆",
    "schema.Facts.handle": "操作力的作用点，力沿该点的轨迹",
    "schema.Facts.outline": "盖板平台（panel）轮廓上依次排列的点；绘出其扫过的区域",
    "schema.Facts.samples": "驱动范围的等分步数",
}
