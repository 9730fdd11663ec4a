//! What a diagnosis says, in Chinese.

/// The English text and its translation.
pub const ZH: &[(&str, &str)] = &[
    // Lists.
    (", ", "、"),
    (" and ", "与"),
    // The answer.
    ("{times} times the error that noise and the form of curves leave", "噪声和曲线形式所留误差的 {times} 倍"),
    ("{effect} ({percent} sure)", "{effect}（把握 {percent}）"),
    (
        "missing: {names}; what is left falls from {before} to {after} times",
        "缺少：{names}；剩余误差由{before}降至 {after} 倍",
    ),
    (
        "{percent} of the disagreement is not explained by what was named: another form of it, or something else",
        "{percent} 的偏差未被所确定的效应解释：是它的另一种形式，或是别的原因",
    ),
    ("{test} ({times} times)", "{test}（{times} 倍）"),
    (
        "too rare or too small to be named, but these tests are missed: {tests}",
        "太少或太小而无法确定，但以下试验的误差明显：{tests}",
    ),
    (
        "nothing is missing that these records can show ({percent} sure): the model is off by {times}{not_seen}{not_confirmed}",
        "没有这些记录能够显示的缺失效应（把握 {percent}）：模型偏差为{times}{not_seen}{not_confirmed}",
    ),
    ("; they cannot show {names}", "；它们无法显示 {names}"),
    ("; no test was left out to confirm it", "；没有留出试验来证实"),
    (
        "something is missing: the model is off by {times}, and {why}{place}",
        "缺少某种效应：模型偏差为{times}，{why}{place}",
    ),
    (
        "{effect} is the likeliest name, but too few tests speak for it to give it",
        "{effect} 是最可能的名称，但支持它的试验太少，不足以确定",
    ),
    ("these records cannot tell {names} apart", "这些记录无法区分 {names}"),
    ("; it acts in the path \"{path}\" ({percent})", "；它作用于“{path}”路径（{percent}）"),
    (
        "the model is off by {times}, and none of the known effects is likely enough to explain that{nearest}",
        "模型偏差为{times}，已知效应都不足以解释{nearest}",
    ),
    ("; it looks like {what}, which explains {percent}", "；看起来像{what}，可解释 {percent}"),
    ("; the nearest, {effect}, explains {percent}", "；最接近的 {effect} 可解释 {percent}"),
    ("explains {percent} of the disagreement", "可解释 {percent} 的偏差"),
    (
        "explains {percent} of the disagreement, with numbers that dampers hardly show",
        "可解释 {percent} 的偏差，但数值在减振器中少见",
    ),
    // What a disagreement without a name looks like.
    (
        "friction that grows with the force, as a tilted cross-head or eye makes in the guides",
        "随力增大的摩擦，如倾斜的横梁或吊环在导向处产生的那样",
    ),
    (
        "a loop over force whatever the speed, as a load cell with hysteresis draws",
        "与速度无关的力回线，如有滞回的力传感器所画出的那样",
    ),
    (
        "a resonance in the path of the force, as of a frame or of oil in a hose",
        "力传递路径中的共振，如机架或软管中油液的共振",
    ),
    // Regions.
    (
        "{direction}, {slow}–{fast} m/s{phase}, {place}: {missing} (rms {rms} N, noise {noise} N)",
        "{direction}，{slow}–{fast} m/s{phase}，{place}：{missing}（均方根 {rms} N，噪声 {noise} N）",
    ),
    ("rebound", "复原"),
    ("compression", "压缩"),
    (" while it speeds up", "（加速时）"),
    (" while it slows down", "（减速时）"),
    ("in all tests that go there", "到达该处的全部试验中"),
    ("in test {test}", "试验 {test} 中"),
    ("measured force is {mean} N ± {error} more tensile than computed", "实测力比计算力偏拉 {mean} N ± {error}"),
    ("measured force is {mean} N ± {error} more compressive than computed", "实测力比计算力偏压 {mean} N ± {error}"),
    ("{rms} N rms off in both senses", "正负两个方向均有偏差，均方根 {rms} N"),
    // Tests that would tell more.
    (
        "run a sine of {amplitude} mm at {frequency} Hz{about}{under}: {a} and {b} differ there by {difference} N rms",
        "进行 {amplitude} mm、{frequency} Hz 的正弦试验{about}{under}：{a} 与 {b} 在此相差均方根 {difference} N",
    ),
    (" about {mean} mm", "，平均位置 {mean} mm"),
    (" under {force} N side force", "，侧向力 {force} N"),
    ("{effect} shows best in: {remedy}", "最能显示 {effect} 的试验：{remedy}"),
    (
        "at a usual strength it would leave no trace in these tests: {remedy}",
        "以通常的强度，它在这些试验中不会留下痕迹：{remedy}",
    ),
    (
        "the tube widens in proportion to pressure like the oil column yields: a rig shows their sum, which oil_compressibility stands for",
        "缸筒随压力膨胀，与油柱的压缩成比例：台架只显示两者之和，由 oil_compressibility 代表",
    ),
    // The test that shows an effect best.
    ("more amplitudes and frequencies", "更多的振幅和频率"),
    (
        "slow triangles at 0.5 to 30 mm/s, two strokes, two temperatures",
        "0.5 至 30 mm/s 的慢速三角波，两种行程，两种温度",
    ),
    (
        "stroke the whole travel slowly, and once at 1 Hz, at two mean positions",
        "慢速走完全行程，并以 1 Hz 走一次，取两个平均位置",
    ),
    ("0.05 to 0.5 mm sines at 1 to 30 Hz", "1 至 30 Hz、0.05 至 0.5 mm 的正弦"),
    ("read the force at rest, with and without the damper hooked in", "读取静止时的力，分别在装上和拆下减振器时"),
    (
        "strokes of 0.1 to 2 mm at 0.1 and 1 Hz: equal loops speak for it",
        "0.1 和 1 Hz 下 0.1 至 2 mm 的行程：回线相同即为佐证",
    ),
    ("the same sine at 0, 500 and 1000 N side force", "同一正弦，侧向力 0、500 和 1000 N"),
    (
        "one peak velocity at several strokes and frequencies, at two mean positions",
        "同一峰值速度，多种行程和频率，两个平均位置",
    ),
    ("one test after a night's rest and after 200 cycles", "静置一夜后和运行 200 个周期后各做一次同样的试验"),
    ("one peak velocity at several strokes, with the gas pressure raised", "同一峰值速度，多种行程，提高气体压力"),
    (
        "a reference test repeated cold and hot, in shuffled order, with the temperature recorded",
        "冷态和热态重复同一参考试验，顺序打乱，并记录温度",
    ),
    ("5 to 10 mm sines at five or more mean positions", "在五个或更多平均位置做 5 至 10 mm 的正弦"),
    ("push slowly into the stop, then at two speeds", "慢速压入限位，再以两种速度压入"),
    ("pull slowly into the stop, then at two speeds", "慢速拉入限位，再以两种速度拉入"),
    (
        "small strokes with a preload that keeps the force from crossing zero, and without",
        "小行程试验，分别有和没有使力不过零的预载",
    ),
    ("one peak velocity at 0.5, 1, 2, 5 and 10 Hz", "同一峰值速度，0.5、1、2、5 和 10 Hz"),
    ("slow ramps of velocity through the knee, up and down", "缓慢升降速度，通过特性曲线拐点"),
    ("run the rig without the damper", "不装减振器运行试验台"),
    ("run a spring in place of the damper: its loop must close", "用弹簧代替减振器运行：其回线必须闭合"),
    ("repeat a reference test at the start, middle and end", "在开始、中间和结束时重复参考试验"),
    // Why records cannot show an effect.
    (
        "it is part of the series path: the model needs series_compliance first",
        "它属于串联路径：模型首先需要 series_compliance",
    ),
    (
        "a free FV curve takes a v² term up: it needs the curve fixed by a specification",
        "自由的 FV 曲线会吸收 v² 项：需要由规格固定该曲线",
    ),
    (
        "the side force does not vary: run the same sine under two or more side forces, with the channel recorded",
        "侧向力没有变化：在两种或更多侧向力下做同一正弦，并记录该通道",
    ),
    (
        "no temperature channel varies, and the records' clocks show no heating: record the oil or tube temperature, or repeat one test cold and after hard work",
        "没有变化的温度通道，记录的时钟也显示没有升温：请记录油温或筒温，或在冷态和剧烈工作后重复同一试验",
    ),
    (
        "all tests pass the same places at the same speeds: run one small sine at five or more mean positions, or one peak velocity at several strokes",
        "所有试验都以相同速度经过相同位置：在五个或更多平均位置做小幅正弦，或以多种行程做同一峰值速度",
    ),
    (
        "only within the {reach} mm of compression that the tests reach: push slowly further to see a stop beyond",
        "仅限试验所达到的 {reach} mm 压缩行程之内：慢速继续压缩才能看到更远的限位",
    ),
    (
        "only within the {reach} mm of extension that the tests reach: pull slowly further to see a stop beyond",
        "仅限试验所达到的 {reach} mm 拉伸行程之内：慢速继续拉伸才能看到更远的限位",
    ),
    (
        "the tests' frequencies are nearly the same: run one peak velocity at 0.5, 1, 2, 5 and 10 Hz",
        "各试验频率几乎相同：以 0.5、1、2、5 和 10 Hz 做同一峰值速度",
    ),
    (
        "a zero error of the load cell and the gas force are the same constant: read the load cell with the damper unhooked, before and after",
        "力传感器零点误差与气体力是同一常数：请在试验前后拆下减振器读取力传感器",
    ),
    (
        "every record starts its clock anew: keep one clock through the campaign and repeat a reference test",
        "每条记录都重新计时：整个试验过程使用同一时钟，并重复参考试验",
    ),
    // How the comparison was made.
    (
        "without a reference campaign a name may stand for what is always wrong in the form of the model; where a good damper was measured on the same rig, --reference asks what changed",
        "没有参考试验时，名称可能代表模型形式中固有的误差；若在同一试验台上测过完好的减振器，可用 --reference 查明变化",
    ),
    (
        "compared with the reference campaign: what the model leaves of the same tests there is taken out{aside}",
        "与参考试验对比：模型在参考的相同试验中留下的残差已扣除{aside}",
    ),
    (
        "; {count} tests have no counterpart there and were left aside: {tests}",
        "；{count} 个试验在参考中没有对应，未予采用：{tests}",
    ),
    // Where in the way of the force an effect acts.
    ("gas and springs", "气体与弹簧"),
    ("friction", "摩擦"),
    ("series", "串联"),
    ("hydraulic", "液压"),
    ("rig", "试验台"),
    ("nothing", "无"),
    ("something else", "其他"),
    // Families of effects.
    ("constant force", "恒力"),
    ("spring", "弹簧"),
    ("dry friction", "干摩擦"),
    ("viscous friction", "粘性摩擦"),
    ("friction under load", "受载摩擦"),
    ("mount", "安装支座"),
    ("oil column", "油柱"),
    ("void", "空穴"),
    ("oil temperature", "油温"),
    ("valves", "阀"),
    ("stop", "限位"),
    ("mass", "质量"),
    ("timing", "时序"),
    ("load cell", "力传感器"),
    // What an effect is.
    ("constant gas force", "恒定气体力"),
    ("growth of the gas force with the displacement of the rod, slow to fast", "气体力随活塞杆位移的增长，由慢到快"),
    ("dry friction of constant level, F_s tanh(K v)", "恒定水平的干摩擦，F_s tanh(K v)"),
    ("dry friction with a break-away peak", "带起动峰值的干摩擦"),
    (
        "friction that turns over within a short travel after each reversal (Dahl)",
        "每次换向后在短行程内反转的摩擦（Dahl）",
    ),
    ("viscous friction, F_v v|v|", "粘性摩擦，F_v v|v|"),
    ("dry friction proportional to side force", "与侧向力成正比的干摩擦"),
    (
        "series spring and damper with the internal mass (compressibility of gas, oil and mount)",
        "带内部质量的串联弹簧和阻尼（气体、油液和支座的柔度）",
    ),
    (
        "rubber in line with the damper: the series spring hardens and loses energy; needs series_compliance",
        "与减振器串联的橡胶：串联弹簧变硬并耗能；需要 series_compliance",
    ),
    (
        "spring parallel to the primary damper: linear, quadratic, cubic, quartic or lookup",
        "与主减振器并联的弹簧：一次、二次、三次、四次或查表",
    ),
    (
        "compressibility of the oil column (with the expansion of the cylinder) before the valves",
        "阀前油柱的可压缩性（含缸筒膨胀）",
    ),
    ("air in the oil: the oil column is soft while the force is small", "油中含气：力较小时油柱较软"),
    (
        "cavitation: the hydraulic force of one stroke is capped, and a void remains to be closed",
        "空化：一个行程的液压力受限，并留下须闭合的空穴",
    ),
    (
        "damping that falls with the temperature of the oil, measured or by its own heat",
        "随油温下降的阻尼，油温为测得或由自身发热",
    ),
    ("damping that is weaker (bypass) or firmer over a part of the stroke", "在部分行程内较弱（旁通）或较硬的阻尼"),
    ("stop at the end of the compression stroke, rubber or hydraulic", "压缩行程末端的限位，橡胶或液压"),
    ("stop at the end of the rebound stroke, rubber or hydraulic", "复原行程末端的限位，橡胶或液压"),
    ("free play in an eye or mount; needs series_compliance", "吊环或支座中的间隙；需要 series_compliance"),
    (
        "damping that is weaker in fast strokes than in slow ones of the same speed",
        "相同速度下，高频行程中弱于低频行程的阻尼",
    ),
    (
        "blow-off valve that opens late and closes late: more force while speed rises",
        "开启和关闭滞后的卸荷阀：速度上升时力更大",
    ),
    (
        "mass moved by the driven end, between load cell and damper, or by the piston",
        "由驱动端（力传感器与减振器之间）或活塞带动的质量",
    ),
    ("the force channel lags the motion channels (rig)", "力通道滞后于运动通道（试验台）"),
    ("the load cell does not read zero without load (rig)", "力传感器无载荷时不为零（试验台）"),
    ("the zero of the load cell moves with time (rig)", "力传感器零点随时间漂移（试验台）"),
    // Forms of effects.
    ("full", "完整"),
    ("slips from the first", "一开始即滑移"),
    ("bends before it slips", "先变形后滑移"),
    ("relaxes", "松弛"),
    ("friction in the rubber", "橡胶内摩擦"),
    ("relaxes over decades and meets a stop", "跨数个时间量级松弛并碰到限位"),
    ("friction in the rubber, and a stop", "橡胶内摩擦，并有限位"),
    ("all of the force goes through it", "全部力经过它"),
    ("relaxes, and all of the force goes through it", "松弛，且全部力经过它"),
    ("friction in the rubber, and all of the force goes through it", "橡胶内摩擦，且全部力经过它"),
    ("rebound chamber", "复原腔"),
    ("both chambers", "两腔"),
    ("one chamber softer than the other", "一腔比另一腔软"),
    ("compression capped, gas pushes on", "压缩力受限，气体继续推动"),
    ("compression capped, dead return", "压缩力受限，回程无力"),
    ("rebound capped, force stays", "复原力受限，力保持"),
    ("rebound capped, dead return", "复原力受限，回程无力"),
    ("compression capped, gas expands in the void", "压缩力受限，气体在空穴中膨胀"),
    ("foot valve does not refill", "底阀不补油"),
    ("measured temperature", "实测温度"),
    ("oil warmer than measured", "油温高于实测"),
    ("heated by its own work", "自身做功发热"),
    ("isothermal", "等温"),
    ("takes time to cool", "冷却需要时间"),
    ("both strokes", "两个行程"),
    ("groove", "沟槽"),
    ("groove open in rebound", "复原时沟槽开通"),
    ("groove open in compression", "压缩时沟槽开通"),
    ("bypass", "旁通"),
    ("filter", "滤波"),
    ("stroke", "行程"),
    ("a valve with play", "有间隙的阀"),
    ("a valve with mass", "有质量的阀"),
    ("opens and closes at different forces", "开启力与关闭力不同"),
    ("rubber", "橡胶"),
    ("hydraulic, gap", "液压，环隙"),
    ("hydraulic, orifice", "液压，节流孔"),
    ("at the load cell", "在力传感器处"),
    ("inside, like oil in a long passage", "在内部，如长通道中的油液"),
    ("low-pass filter of the force channel", "力通道的低通滤波"),
    ("zero set anew during the campaign", "试验过程中重新调零"),
    ("settles as the rig warms up", "随试验台升温而稳定"),
];
