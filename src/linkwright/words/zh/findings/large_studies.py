"""Problems of large studies: memory, disk, workers."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "file.link": (
        "{file} 是符号链接；linkwright 不通过链接写入。",
        "删除该链接，或给出其指向的路径。",
    ),
    "folder.busy": (
        "另一个 linkwright 进程正在写入文件夹 {folder}。",
        "等待其结束，或用 --out 指定其他文件夹。",
    ),
    "folder.busy-with": (
        "另一个 linkwright 进程正在写入文件夹 {folder}：模型 {model}，开始于 {date}，主机 {host} 上的进程 {process}。",
        "等待其结束，或用 --out 指定其他文件夹。",
    ),
    "folder.foreign": (
        "{folder} 中的以下文件将被覆盖，但它们不是由 linkwright 写入的，或写入后已被修改：{files}。",
        "移走这些文件或将其改名，用 --out 指定其他文件夹，或加 --force 将其覆盖。",
    ),
    "blocks.other-version": (
        "文件 {file} 中的分析状态由 {theirs} 创建，而当前为 {ours}，两者的结果可能不同。",
        "用 {theirs} 继续，或用 --fresh 重新开始（在 Python 中为 fresh=True；对 Checkpoint 或数据存储为 anew=True）。",
    ),
    "blocks.holes": (
        "数据存储 {file} 的 {total} 个数据块中有 {count} 个缺失或不完整：有其他程序写入过。",
        "再次运行同一分析：只计算缺失的部分。",
    ),
    "blocks.busy": (
        "另一个进程正在写入 {file}。",
        "等待其结束，或将本分析存入其他文件。",
    ),
    "blocks.other-work": (
        "文件 {file} 中是另一个分析的状态：模型或选项不同。",
        "改用其他文件，恢复原来的模型和选项，或重新开始分析（将覆盖该文件）。",
    ),
    "blocks.corrupt": (
        "文件 {file} 中的分析状态已损坏。",
        "用备份恢复该文件，或重新开始分析（将覆盖该文件）。",
    ),
    "blocks.no-space": (
        "磁盘空间不足，无法写入 {file}：{reason}。",
        "释放磁盘空间后再次运行同一分析：从已保存的状态继续。",
    ),
    "blocks.unwritable": (
        "无法写入 {file}：{reason}。",
        "排除原因后再次运行同一分析：从已保存的状态继续。",
    ),
    "blocks.cluster-unreachable": (
        "{address} 处的 Dask 调度器没有响应：{reason}。",
        "检查地址（形如 tcp://host:8786）是否正确、该处是否运行着“dask scheduler”，以及防火墙是否允许连接。",
    ),
    "blocks.cluster-lost": (
        "与 {address} 处的 Dask 调度器的连接已断开。",
        "重新启动调度器及其工作进程，再次运行同一分析：从已保存的状态继续。",
    ),
    "blocks.cluster-idle": (
        "{address} 处的 Dask 调度器已有 {seconds} s 没有工作进程。",
        "启动工作进程（“dask worker {address}”），再次运行同一分析：从已保存的状态继续。",
    ),
    "blocks.workers-died": (
        "集群的多个工作进程在计算同一组计算单元（{first} 至 {last}）时异常终止。",
        "检查工作进程的日志。常见原因是内存不足：为每个工作进程分配更多内存，或减少线程数。",
    ),
}
