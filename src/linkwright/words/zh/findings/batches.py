"""Problems of batches of parameter sets."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "batch.head": (
        "列名“{head}”无法识别。",
        "写参数名，并在方括号中注明单位，例如 x1 [mm]。",
    ),
    "batch.no-name": (
        "文件中没有“name”列。现有的列：{known}。",
        "添加 name 列，并为每行给出名称；“linkwright new hinge --table”可生成一个初始文件。",
    ),
    "batch.parameter": (
        "本行所用的模型“{model}”没有参数“{name}”。",
        "将该单元格留空，或在 model 列中指定其他模型。",
    ),
    "batch.empty": (
        "文件 {file} 中除列名外没有数据行。",
        "每个机构添加一行；“linkwright new hinge --table”可生成一个初始文件。",
    ),
    "batch.cells": (
        "本行有 {count} 个单元格，而列数为 {heads}。",
        "删除多余的单元格；单元格内含逗号时，须用引号将该单元格括起来。",
    ),
    "batch.name": (
        "名称“{name}”不能用作文件名的开头。",
        "使用汉字、字母、数字、空格、点号、连字符和下划线，不超过 60 个字符，且以汉字、字母或数字开头。",
    ),
    "batch.name-twice": (
        "名称“{name}”已在第 {first} 行使用。",
        "各行的名称必须不同，且不区分大小写。",
    ),
    "batch.model": (
        "示例库中没有模型“{name}”，本文件所在的文件夹中也没有此文件。",
        "{near}也可以写模型文件的路径。",
    ),
}
