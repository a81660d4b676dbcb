"""Words of the export to Process Simulate."""

TEXTS: dict[str, str] = {
    "functions.head": "# {title}：Process Simulate 运动副函数，语法格式 {dialect}",
    "functions.units": "# 单位：rad 和 mm。每个函数为一行文本，属于其上方所列的运动副。",
    "functions.proof": "# 已在整个范围内与求解器核对：取 {decimals} 位小数时最大偏差 {error}。",
    "functions.master": "# 以 {master} 代替 {drive} 所驱动的运动副作为主动运动副：在此范围内其运动不换向。",
    "functions.mirror": "# 两个同步运动的镜像铰链：{master} 主动，第二个铰链上的 {follower} 随动。",
    "functions.compared": "# 凸轮的函数含有比较运算 >= 和 <：成立时为 1，否则为 0。",
    "functions.fitted": "# 没有封闭解的运动副用多项式近似，其误差已列出。",
    "functions.driving": "{name}：主动运动副，类型 {kind}，{child} 相对 {parent}（模型中为 {joint}），{way}；限位 {limits}",
    "functions.joint": "{name}：类型 {kind}，{child} 相对 {parent}（模型中为 {joint}），{way}；限位 {limits}；最大偏差 {error}",
    "functions.helper": "{name}：辅助运动副 D，所属构件无几何形状，轴线任意；限位 {limits}",
    "functions.T+": "逆时针为正",
    "functions.T-": "顺时针为正",
    "functions.D+": "沿直线方向为正",
    "functions.D-": "沿直线反方向为正",
    "functions.snippet": "按名称为各运动副赋值；Process Simulate 接受的各段文本不带引号。",
    "functions.done": "{count} 个运动副函数，语法格式 {dialect}：取 {decimals} 位小数时最大偏差 {error}（rad 或 mm）；最长的有 {longest} 个字符。",
}
