"""Words of batches of exports."""

TEXTS: dict[str, str] = {
    "batch.title": "{model}, {name}",
    "batch.row": "{name}: {text}",
    "batch.page.title": "{file}: export to {target}",
    "batch.page.subtitle": "{count} rows, all exported and verified. Columns as in the file; a blank cell uses the model's value.",
    "batch.page.name": "Name",
    "batch.page.model": "Model",
    "batch.page.result": "Result",
    "batch.page.files": "Files",
    "batch.page.footer": "Made with linkwright {version} from {file} ({sha256}), {date}.",
}
