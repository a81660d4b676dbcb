"""Words of batches of exports."""

TEXTS: dict[str, str] = {
    "batch.title": "{model}，{name}",
    "batch.row": "{name}：{text}",
    "batch.page.title": "{file}：导出到 {target}",
    "batch.page.subtitle": "共 {count} 行，全部已导出并通过验证。各列与文件相同；空单元格采用模型中的数值。",
    "batch.page.name": "名称",
    "batch.page.model": "模型",
    "batch.page.result": "结果",
    "batch.page.files": "文件",
    "batch.page.footer": "由 linkwright {version} 根据 {file}（{sha256}）生成，{date}。",
}
