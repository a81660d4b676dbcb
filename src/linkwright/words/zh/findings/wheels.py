"""齿轮、齿条、带传动与滚动接触的问题。"""

PROBLEMS: dict[str, tuple[str, str]] = {
    "joint.carrier": (
        "行星架（转臂）“{carrier}”未在 {centre} 处与 {wheel} 铰接，因此中心距没有保证。",
        "用 carrier 给出在两轮中心处都与其铰接的构件，例如“carrier: arm”；不写 carrier 时为机架。满足条件的构件：{able}。",
    ),
    "differential.count": (
        "差速器有 {shafts} 个轴，但给出了 {weights} 个权。",
        "按 differential 的顺序为每个轴给出一个权，例如 '{{differential: [cage, left, right], weights: [2, -1, -1]}}'。",
    ),
    "differential.weight": (
        "轴 {link} 的权为 0，差速器不能带动它。",
        "给出不为 0 的数，或去掉该轴。行星轮系中太阳轮、内齿圈和转臂的权为 [z_sun, z_ring, -(z_sun + z_ring)]。",
    ),
    "gears.size": (
        "齿轮副必须给出齿数或节圆半径之一；已给出：{given}。",
        "例如 teeth: [20, 40]，按 gears 的顺序给出两轮齿数（已知模数时再给 module），或 radii: [30, 60]。",
    ),
    "gears.module": (
        "给出了模数，但没有齿数。",
        "用 teeth: [20, 40] 代替 radii，或删除 module。",
    ),
    "gears.internal": (
        "内齿轮“{name}”不是这两个齿轮之一：{gears}。",
        "写内齿圈所在的构件，例如 gears: [planet, ring], internal: ring。",
    ),
    "gears.ring": (
        "内齿圈 {ring} 不大于其内部的齿轮。",
        "按 gears 的顺序给内齿圈较多的齿数或较大的半径：gears: [planet, ring], teeth: [20, 80]。外啮合时请删除 internal。",
    ),
    "gears.whole": (
        "齿数不是整数。",
        "写整数，例如 teeth: [20, 40]；任意传动比请用 radii 给出。",
    ),
    "gears.pressure": (
        "压力角不在 0 与 90 deg 之间。",
        "写轮齿的压力角，通常为 20 deg；没有径向分离力的轮写 0 deg（此时不写 module）。",
    ),
    "gears.concentric": (
        "两个齿轮的中心位于 {carrier} 的同一处。",
        "在该构件上给出两个相距为中心距的点。同轴的轮请放在同一个构件上。",
    ),
    "gears.distance": (
        "齿轮不匹配：由节圆半径得到的中心距为 {radii}，而 {carrier} 上的中心距为 {distance}。",
        "修改 radii 或 {carrier} 上的点；也可改为给出 teeth，节圆半径由中心距得出。",
    ),
    "gears.shift": (
        "齿轮不匹配：按此模数，标准中心距为 {reference}，而 {carrier} 上的中心距为 {distance}。",
        "修改 module、teeth 或 {carrier} 上的点。变位引起的中心距变化最多为一个模数，且工作压力角必须存在：中心距大于标准中心距与压力角余弦之积。",
    ),
    "gears.pinion": (
        "齿条副必须给出小齿轮的节圆半径，或齿数和模数；已给出：{given}。",
        "例如 radius: 25 mm，或 teeth: 20 与 module: 2.5 mm。",
    ),
    "gears.guide": (
        "构件“{carrier}”不能保持 {pinion} 与 {rack} 的距离：它必须在小齿轮中心处与其铰接，且齿条必须在其上滑动。",
        "用 carrier 给出同时具有这两个运动副的构件，例如“carrier: housing”；不写 carrier 时为机架。满足条件的构件：{able}。",
    ),
    "gears.rack-line": (
        "齿条 {rack} 的节线与齿条的导轨不平行。",
        "使该直线的方向与移动副在此构件上的直线方向一致。",
    ),
    "gears.path": (
        "圆盘的滚动必须在 on_line 和 on_circle 中给出且只给出一项；已给出：{given}。",
        "例如 on_line: G at 0 deg，或 on_circle: {{centre: M, radius: 80}}；圆盘在环内滚动时加 inside: true。",
    ),
    "gears.same-radius": (
        "圆盘与其内部滚动的圆一样大，无法滚动。",
        "使圆的半径与圆盘半径不同；不写 inside 时圆盘在圆的外侧滚动。",
    ),
    "gears.rack-distance": (
        "齿条不匹配：节线到小齿轮中心的距离为 {distance}，而节圆半径为 {radius}。",
        "修改半径（齿数、模数），或直线、导轨和中心的点。给出模数时，变位引起的距离变化最多为一个模数。",
    ),
    "belt.size": (
        "带传动必须给出两轮的节圆半径，或齿数和节距；已给出：{given}。",
        "例如 radii: [30, 60]；同步带或链传动写 teeth: [20, 40] 与 pitch: 5 mm。",
    ),
    "belt.friction": (
        "给出了摩擦系数，但没有预紧力。",
        "增加 pretension，即静止时每边的力，例如 200 N；或删除 friction。",
    ),
    "belt.distance": (
        "两轮重叠：中心距为 {distance}，半径之和为 {radii}。",
        "修改 radii（齿数、节距）或行星架上两中心处的点。",
    ),
    "belt.slack": (
        "{joint}（{kind}）的一边松弛：在 t = {time} s（{drive} = {value} {unit}）时，它需要承受 {force} {of} 的压力。此后的力不再是带的力。",
        "增大预紧力 pretension；松边下垂的链或同步带请删除 pretension。",
    ),
    "belt.slips": (
        "{joint}（{kind}）打滑：在 t = {time} s（{drive} = {value} {unit}）时，按欧拉公式的极限，切向力不足 {force} {of}。",
        "增大预紧力或包角，或采用摩擦系数更大的带。",
    ),
    "geneva.motor": (
        "没有驱动使该槽轮机构的拨盘“{driver}”相对“{carrier}”转动，槽轮因此没有运动规律。",
        "为拨盘给出驱动，例如“drives: {{motor: {{turns: {driver}, on: {carrier}, speed: 60 rpm, start: 0 deg}}}}”；按输出构件给出规律的驱动不算在内。",
    ),
    "geneva.frame": (
        "机架是该槽轮机构的拨盘或槽轮，不能同时作为支承两者的构件。",
        "用 carrier 给出在两个中心处与拨盘和槽轮铰接的构件，例如“carrier: arm”。",
    ),
    "geneva.slots": (
        "槽数不是 {fewest} 到 {most} 之间的整数。",
        "例如 slots: 4；要减小最大角加速度可用 6。",
    ),
    "geneva.concentric": (
        "拨盘与槽轮的中心位于 {carrier} 的同一位置。",
        "在 {carrier} 上给出相距为槽轮机构中心距的两个点。",
    ),
    "geneva.entry": (
        "圆销 {pin} 进槽时有冲击：它到 {centre} 的距离为 {radius}，而中心距为 {distance}、槽数如上时应为 {wanted}。",
        "圆销的回转半径取中心距乘 sin(180 deg/slots)，例如用参数“r: c*sin(180 deg/4)”。",
    ),
    "geneva.pins": (
        "圆销 {first} 和 {second} 会同时处于槽中。",
        "圆销之间的夹角至少为 180 deg - 360 deg/slots，例如两个圆销相对布置；或去掉其中一个。",
    ),
    "geneva.arc": (
        "锁止弧尺寸不合适：其半径为 {radius}，必须大于 {low} 才能到达槽轮外缘，并小于 {high} 才能给圆销留出空间。",
        "使 arc 的半径介于两者之间，通常为圆销回转半径减去圆销直径。",
    ),
    "geneva.horn": (
        "{joint} 的锁止盘在需要锁住槽轮处有缺口：t = {time} s 时给出的力 {force} 作用在槽轮锁止弧的一个端点上，而锁止盘此时并未到达该端点，"
        "实际由锁止盘的边缘承力，力更大。",
        "圆销进槽前和出槽后，拨盘在 {span} 的转角内只能在一个方向锁住槽轮。请平衡槽轮或加制动，使该处没有反方向的力矩；给出的力按力臂 {arm} 计算，"
        "在其他位置是正确的。",
    ),
}
