"""English words, by key. Chinese and others follow as packages beside this one."""

from linkwright.words.en.accuracy import ACCURACY
from linkwright.words.en.findings import FINDINGS
from linkwright.words.en.limits import LIMITS
from linkwright.words.en.report import REPORT
from linkwright.words.en.sweep import SWEEP
from linkwright.words.en.texts import TEXTS
from linkwright.words.en.workspace import WORKSPACE
from linkwright.words.en.workspace_maps import WORKSPACE_MAPS
from linkwright.words.en.workspace_paths import WORKSPACE_PATHS

WORDS: dict[str, str] = {
    **ACCURACY,
    **FINDINGS,
    **LIMITS,
    **REPORT,
    **SWEEP,
    **TEXTS,
    **WORKSPACE,
    **WORKSPACE_MAPS,
    **WORKSPACE_PATHS,
}
