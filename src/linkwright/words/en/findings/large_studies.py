"""Problems of large studies: memory, disk, workers."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "file.link": (
        "{file} is a symbolic link; linkwright doesn't write through links.",
        "Remove the link, or give the path that it points to.",
    ),
    "folder.busy": (
        "Another run is writing to the folder {folder}.",
        "Wait until it ends, or choose another folder with --out.",
    ),
    "folder.busy-with": (
        "Another run is writing to the folder {folder}: {model}, started {date}, process {process} on {host}.",
        "Wait until it ends, or choose another folder with --out.",
    ),
    "folder.foreign": (
        "These files in {folder} would be overwritten, but linkwright didn't write them or they were changed since: {files}.",
        "Move or rename them, choose another folder with --out, or add --force to overwrite them.",
    ),
    "blocks.other-version": (
        "The file {file} contains the state of a study that was started with {theirs}; this is {ours}, whose results "
        "may differ.",
        "Resume it with {theirs}, or restart it with --fresh (in Python fresh=True; anew=True for a Checkpoint or "
        "store).",
    ),
    "blocks.holes": (
        "The store {file} lacks {count} of its {total} chunks, or they are truncated: another program has written to "
        "it.",
        "Run the same study again: it computes only what is missing.",
    ),
    "blocks.busy": (
        "Another process is writing to {file}.",
        "Wait until it ends, or use another file for this study.",
    ),
    "blocks.other-work": (
        "The file {file} contains the state of another study: the model or the options differ.",
        "Use another file for this study, restore the original model and options, or restart the study, which "
        "overwrites the file.",
    ),
    "blocks.corrupt": (
        "The file {file} contains the state of a study, but it is damaged.",
        "Restore a copy of it, or restart the study, which overwrites the file.",
    ),
    "blocks.no-space": (
        "There is no disk space left for {file}: {reason}.",
        "Free some space and run the same study again: it resumes from the saved state.",
    ),
    "blocks.unwritable": (
        "Can't write to {file}: {reason}.",
        "Fix the cause and run the same study again: it resumes from the saved state.",
    ),
    "blocks.cluster-unreachable": (
        "No Dask scheduler answers at {address}: {reason}.",
        "Check the address (such as tcp://host:8786), that 'dask scheduler' runs there, and that the firewall allows "
        "the connection.",
    ),
    "blocks.cluster-lost": (
        "The connection to the Dask scheduler at {address} was lost.",
        "Start the scheduler and its workers again, then run the same study: it resumes from the saved state.",
    ),
    "blocks.cluster-idle": (
        "The Dask scheduler at {address} has had no workers for {seconds} s.",
        "Start workers ('dask worker {address}'), then run the same study: it resumes from the saved state.",
    ),
    "blocks.workers-died": (
        "Several workers of the cluster died while computing the same atoms ({first} to {last}).",
        "Check the workers' logs. The cause is often memory: give each worker more memory, or fewer threads.",
    ),
}
