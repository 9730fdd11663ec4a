### Texts of the reports: Chinese, simplified.

## The page.

decimal-sign = .
note = 注意：
all-tests-shown = 全部试验
previous = 上一个
next = 下一个
test-shown = 显示的试验
figure-help = 在图中拖动可放大，双击恢复全图，移动指针读取数值。
zoom-reset = 全图
save-table = 另存为 CSV
save-about = 各列以逗号分隔，小数用点。
sort-help = 点击表头可排序。
printed-brief = 打印内容为结论及其依据。文件本身包含全部试验和表格；用 --full 生成的报告会全部打印。

## Figures.

measured = 实测
model = 模型
fv-curve = FV 曲线
noise-alone = 仅噪声
axis-velocity = 速度, mm/s
axis-displacement = 位移, mm
axis-force = 力, N
axis-error = 计算 − 实测, N
axis-time = 时间, s
axis-gap = 速度上升 − 下降, N
axis-error-percent = 误差, %
axis-peak-velocity = 峰值速度, mm/s
axis-amplitude = 振幅, mm
plot-force-velocity = 力—速度
plot-force-displacement = 力—位移
plot-force-time = 力—时间
plot-error-velocity = 误差—速度
plot-error-displacement = 误差—位移
plot-force-space = 力—速度—位移
plot-error-space = 误差—速度—位移
plot-gap = 滞回间隙—速度
plot-error-of-tests = 各试验误差，占其最大力的 %
plot-error-map = 按振幅和峰值速度的误差，%
plot-error-map-note = 大字：{ $model }，小字：仅 { $curve }
plot-both-curves = 两支减振器的 FV 曲线（含摩擦力和气体力）
plot-peaks = 峰值力—峰值速度
identified-curve = 辨识曲线（含摩擦力和气体力）
measured-peaks = 实测峰值
model-peaks = 模型峰值
window = 限值

## Validation: title and answer.

title-validation = 减振器模型与台架记录对比
subtitle-validation = 模型 { $model } 与 { $data } 中的台架数据
answer = 结论
over-one-test = 在唯一一个试验中
over-tests = 在 { $tests } 个试验中
headline = { $over }，模型与实测力平均相差 { $error } N，为试验最大力的 { $percent } %。仅用力—速度曲线则相差 { $curve_error } N，{ $curve_percent } %：{ $verdict }{ $closer }。
verdict-exact = 模型与实测完全一致
verdict-smaller = 模型的平均误差为曲线的 1/{ $ratio }
verdict-same = 模型相对曲线没有值得一提的改进
verdict-larger = 模型的平均误差为曲线的 { $ratio } 倍，不如曲线
closer-in = ，并在 { $tests } 个试验中的 { $closer } 个更接近
left-out-figures = { $error } N 或 { $percent } %（仅曲线 { $curve_error } N 或 { $curve_percent } %）
left-out-sentence = 在辨识未使用的 { $left } 个试验上，平均误差为 { $left_figures }；在用于拟合的 { $fitted } 个试验上为 { $fitted_figures }。
only-fitted = 全部试验都用于辨识模型，因此这些数字说明拟合程度，而不说明预测能力。
largest-error = 百分比误差最大的试验是“{ $test }”：{ $percent } %，即 { $force } N 中的 { $error } N。
noise-sentence = 仅实测力的噪声就会产生约 { $noise } N 的平均误差；任何模型都不可能更接近。

## Its sections.

fv-section = FV 曲线与实测峰值
fv-caption-by-setting = 每个点是一个试验在其峰值速度下的力（各周期平均），取该试验的设置。
fv-caption = 每个点是一个试验在其峰值速度下的力（各周期平均）。线是模型在该速度保持不变时的力：FV 曲线、摩擦力和气体力。点偏离线的地方，减振器不只取决于速度。
worst-section = 误差最大的试验：{ $test }
worst-caption = 相对其力的百分比误差最大的试验。
matrix-section = 按振幅和峰值速度的误差
key-section = 误差数据
tests-section = 各试验的误差
single-section = 单个试验
single-about = 按误差排序，最差的在前。回线显示试验最后 { $cycles } 个完整周期；没有完整周期的试验全部显示。误差为计算减实测。滞回间隙为全部完整周期的平均。
single-most = 共 { $tests } 个试验，显示误差最大的 { $shown } 个。
hysteresis-section = 滞回
identification-section = 辨识
parameters-section = 模型参数
parameters-range = 下限和上限为 95 % 区间的两端。
made-section = 本报告的生成方式

## Tables.

col-tests = 试验
col-number = 数量
col-force-of = 力的来源
col-mean-error = 平均误差, N
col-error-percent = 误差, %
col-region1 = 区域 1, N
col-region2 = 区域 2, N
col-rms = 均方根误差, N
col-test = 试验
col-amplitude = 振幅, mm
col-frequency = 频率, Hz
col-peak-velocity = 峰值速度, mm/s
col-max-force = 最大力, N
col-in-fit = 用于拟合
yes = 是
no = 否
group-curve = 仅 FV 曲线
all-tests = 全部试验
used-in-fit = 用于拟合
left-out-of-fit = 未用于拟合
key-caption = 平均误差：一个试验各采样点 |计算 − 实测| 的平均。误差百分比相对该试验的最大实测力。区域 1 和 2：速度低于和高于 { $boundary } mm/s 的采样点对平均误差的贡献，两者之和即平均误差。均方根误差对大偏差加权更多。所有数值为各试验的平均，每个试验权重相同。
row-rule = 每行中各试验权重相同；百分比相对该行的最大力。
by-amplitude = 振幅相同的试验合并。{ $rule }
by-peak-velocity = 峰值速度相同的试验合并。{ $rule }
tests-caption = 各试验单列；百分比相对其自身的最大力。
row-amplitude = 振幅 { $value } mm
row-peak-velocity = 峰值速度 { $value } mm/s
row-slow = 低速摩擦试验，低于 { $value } mm/s
row-not-periodic = 没有完整周期的试验
col-cycles = 周期数
group-gap = 平均间隙, N
group-gap-error = 间隙误差, N
group-area = 回线面积 ∮F dv, N·m/s
group-energy = 能量 ∮F dx, J
col-measured = 实测
col-curve = 曲线
hysteresis-caption = 对完整周期取平均。间隙：相同速度下，速度上升与下降时力之差；其绝对值对试验的各速度取平均。间隙误差：|计算间隙 − 实测间隙| 的平均。回线面积为负表示力滞后于速度（气体和油液的可压缩性），为正表示超前（运动质量）。
col-name = 名称
col-value = 数值
col-unit = 单位
col-low = 下限
col-high = 上限
col-source = 来源
parameter-at = { $place } 处
col-note = 备注
not-identified = 无法由这些数据辨识
not-identified-assumed = 未辨识：假定 { $value }，{ $source }
not-identified-off = 未辨识：其元件已关闭（{ $why }）
assumed-usual = 减振器的常见值（{ $source }）
assumed-dimensions = 根据尺寸（{ $source }）
assumed-default = 模型的默认值
assumed-held = 测量无法确定该值；它介于通常值与最佳拟合之间

## Single tests.

notes-of-test = 读取和清理时所做或发现的：
motion-periodic = 振幅 { $amplitude } mm，{ $frequency } Hz，峰值速度 { $velocity } mm/s，{ $cycles } 个完整周期。
motion-other = 非周期运动，峰值速度 { $velocity } mm/s。
temperature = 温度开始时 { $first } °C，结束时 { $last } °C。
force-noise = 力的噪声均方根 { $noise } N。
test-used = 用于拟合。
test-left-out = 未用于拟合。
test-sentence = 最大力 { $force } N。模型平均误差 { $error } N，{ $percent } %；仅力—速度曲线 { $curve_error } N，{ $curve_percent } %。

## The literature.

family-section = 随设置变化
family-between = 未见过 { $at } 的模型族在该处偏差 { $error } N（{ $percent }），是单独拟合 { $at } 的 { $ratio } 倍。
family-between-worse = 模型在各设置之间不如在设置处：未见过 { $at } 的模型族在该处偏差 { $error } N（{ $percent }），是单独拟合 { $at } 的 { $ratio } 倍。在 { $at } 与相邻设置之间测量最有帮助。
family-about = 该减振器取决于一个设置。每个试验取其自身的设置；模型文件各设置之间采用插值。
family-interpolated = { $setting }（插值）
plot-family = 各设置下恒定速度时的力
family-caption = 模型文件的每个设置一条曲线，其间的试验设置用虚线表示。圆点为峰值速度下的实测力，颜色与其设置相同。
family-table = 各设置下试验的平均值。FV 曲线由该设置的试验拟合。
family-clamped = { $setting }（截断）
family-errors-section = 各设置下的误差
family-left-out-table = 拟合试验平均循环上的平均误差。去掉某一设置的系列由其余设置重新拟合并插值；网格两端没有此值。
family-own-fit = 单独拟合
family-fit = 系列
family-without = 去掉它的系列
col-ratio = 比值
family-loops-section = 各设置的回线
family-loops-about = 具有该运动的各设置下的同一运动：幅值 { $amplitude } mm，峰值速度 { $velocity } mm/s。
family-worst-about = 以下为各设置下百分比误差最大的试验。
family-worst-caption = { $setting }：{ $test }，平均误差 { $error } N，{ $percent } %
plot-over-setting = 力随设置的变化
over-setting-caption = 模型在恒定速度下的力。水平线表示不随设置变化。
plot-ratio = 最硬与最软之比
ratio-caption = { $hard } 时的力除以 { $soft } 时的力，含摩擦，不含气体力，取试验达到的峰值速度。
axis-speed = 速度大小, mm/s
axis-ratio = 比值, -
number-varies = （随设置变化；竖线为 95 % 区间，无竖线的值未能辨识）
number-shared = （各设置共用；竖线为 95 % 区间）
family-numbers-section = 随设置变化的数值
family-numbers-table = 随设置变化的量，以及拟合留下的 95 % 区间。
family-varies = 随设置变化
family-effects = 各效应在每个设置下承担的力：去掉该效应而保留其余时的变化。
family-dependences = 哪些量随设置变化及其概率。
responses-section = 对设置阶跃的响应
responses-about = 沿每个试验的运动，阶跃前设置下的力与阶跃后设置下的力由模型已知。响应是力在两者之间已走过的比例，因此正弦运动中的阶跃与恒速时的阶跃同样有效。
responses-table = 相同两个设置之间所有阶跃的平均响应，实测与模型。时间自阶跃起算；自 10 % 起算的时间不含死区时间。
col-step = 阶跃
col-steps = 阶跃数
col-t63 = 至 63 %，ms
col-t90 = 至 90 %，ms
col-t63-from-10 = 10 至 63 %，ms
col-t90-from-10 = 10 至 90 %，ms
col-overshoot = 超调，%
plot-step-up = 上升阶跃的响应
plot-step-down = 下降阶跃的响应
axis-since-step = 阶跃后的时间, ms
axis-way = 已走比例, -
actuator-table = 执行器的数值，以及拟合留下的 95 % 区间。
actuator-parts = 阀具有的特性及其概率。
col-has-it = 具有
plot-hysteresis-setting = 设置上的滞环
hysteresis-setting-caption = 设置缓慢上升和下降时，模型在 { $velocity } mm/s 下的力。阀在上升时落后 { $hysteresis }，下降时超前同样多。
way-up = 上升
way-down = 下降
family-changing = 变化
response-time-up = 上升阶跃响应，至 63 %，ms
response-time-down = 下降阶跃响应，至 63 %，ms
rise-time-up = 上升阶跃响应，10 至 90 %，ms
rise-time-down = 下降阶跃响应，10 至 90 %，ms
settings-section = 各设置汇总
settings-all = 全部
settings-caption = 减振器在各设置下的每个效应，各设置单独诊断：各自的概率与力。所有设置共有的效应只列一次。
settings-changes = 各设置下相对参考减振器的变化，各设置单独比较：变化前后的值、各自的概率与力。
settings-answers = 各设置下的答案。试验平均循环上的均方根 N：加入效应之前、之后，以及噪声所致。
col-setting = 设置
against-section = 与文献模型对比
against-about = 每个模型都用最小二乘法从多个初值出发，由被验证模型所用的同一批试验辨识，然后用于未参与的试验。均方根误差和平均误差为各试验的平均。
against-caption = 误差百分比相对各试验的最大实测力。
col-model = 模型
col-meaning = 说明

## Limits.

certificate-title = 合格证：减振器与限值
certificate-subtitle = { $data } 中的台架数据，{ $limits } 中的限值
certificate-section = 限值
certificate-pass = 合格。减振器满足全部 { $count } 项限值。
certificate-fail = 不合格。{ $count } 项限值中有 { $failed } 项不满足。
certificate-fail-untested = 不合格。已检验的 { $tested } 项限值中有 { $failed } 项不满足；另有 { $untested } 项无法用这些记录检验：{ $why }。
certificate-untested = 不完整。已检验的 { $tested } 项限值均满足；另有 { $untested } 项无法用这些记录检验：{ $why }。
certificate-nothing-tested = 不完整。{ $count } 项限值均无法用这些记录检验：{ $why }。
certificate-why-untested = 没有该速度的试验，或没有足够慢的试验来测摩擦力和气体力
certificate-why-untested-at-setting = 没有该速度和该设置的试验，没有足够慢的试验来测摩擦力和气体力，或没有这样的设置阶跃
certificate-interpolated = { $tests }，插值
certificate-model-passes = 模型对每项限值给出相同的判定。
certificate-model-fails = 模型对其中 { $count } 项限值的判定与实测不同，因此仿真在那里表现的是另一个减振器。
certificate-caption = 力取峰值速度处，为达到该速度的最长行程试验各周期的平均；在速度相差不超过 { $ratio } 倍的两个试验之间线性插值，否则取速度相差 { $percent }% 以内的试验。复原和拉力为正，压缩为负。气体力和摩擦力为低速试验两个行程的平均值和半差值。滞回为相同速度下速度上升与下降之间的平均间隙。
subject-part = 零件：{ $text }
subject-serial = 序列号：{ $text }
subject-tester = 试验人员：{ $text }
subject-rig = 试验台：{ $text }
subject-measured = 测量日期：{ $text }
subject-temperature = 测量时的温度：{ $low } 至 { $high } °C
to-fill-in = ______________________________
col-limit = 限值
col-at = 速度, mm/s
col-low-limit = 下限
col-high-limit = 上限
col-verdict = 判定
col-from = 取自试验
pass = 合格
fail = 不合格
not-tested = 未检验
force-rebound = 复原力
force-compression = 压缩力
gas-force = 气体力
friction = 摩擦力
hysteresis = 滞回

## How it was made.

made-version = 由 dashpot { $version } 生成。
made-date = 日期：{ $date }。
made-command = 命令：{ $command }
made-again = 相同的版本、命令和文件会再次给出相同的数值。散列值为 SHA-256，与 sha256sum 的输出一致。
col-file = 文件
col-bytes = 字节
made-all = 全部 { $count } 个文件合计：SHA-256 { $hash }（对 sha256sum 按此顺序输出的各行计算）。
made-files = 读取的文件。

## Manoeuvres.

manoeuvre-title = 行驶工况 { $name }
manoeuvre-subtitle = 模型 { $model } 与其 FV 曲线，步长 { $step } s
manoeuvre-answer = 使用模型时减振器最大力为 { $force } N，仅用 FV 曲线为 { $curve } N，均在 { $corner }；该处两者的力相差均方根 { $difference } N，为力的均方根的 { $share } %。
manoeuvre-answer-same = 在该工况中模型与其 FV 曲线给出相同的力。
manoeuvre-beyond = 减振器 { $corner } 的速度为 { $saw } mm/s；其 FV 曲线在 { $ends } mm/s 范围内辨识，超出部分按直线延伸，占 { $share } % 的时间。
manoeuvre-quiet = 步长为 { $host } ms 时，力与运动的交换发生颤振：使用 FV 曲线的力因此最多增加 { $curve } N（有效值），使用模型的力增加 { $model } N。因此力和垂向位移的差值取自 { $quiet } ms 的步长；其余均与宿主软件的计算一致。
manoeuvre-chassis = 车身垂向加速度：最大 { $peak } m/s²（FV 曲线 { $peak_curve }），均方根 { $rms } m/s²（FV 曲线 { $rms_curve }）；垂向位移相差均方根 { $heave } mm。
corner-section = 减振器力
corner-force-velocity = { $corner }：力—速度
corner-force-time = { $corner }：力—时间
corner-difference = { $corner }：模型减 FV 曲线
axis-difference = 模型 − FV 曲线, N
corners-table = 各车轮数据
corners-caption = 各减振器所经历的和所产生的。L1 为左前，R2 为右后。
col-corner = 车轮
group-largest-force = 最大力, N
group-energy-j = 能量, J
col-rms-difference = 均方根差, N
road-section = 路面和车速
road-caption = 前轮下的路面（左、右）。车速为 { $speed } km/h。
plot-road = 前轮下的路面
axis-road = 路面高度, mm
chassis-section = 车身
plot-heave = 车身垂向位移
plot-heave-acceleration = 车身垂向加速度
plot-roll = 侧倾
plot-lateral = 侧向加速度
axis-heave = 垂向位移, mm
axis-heave-acceleration = 垂向加速度, m/s²
axis-roll = 侧倾角, °
axis-lateral = 侧向加速度, m/s²
region-section = 工作范围
region-with-tests = 减振器的工作范围，底图为台架试验测得的回线。在其之外模型未经检验。
region-without-tests = 减振器的工作范围。使用 --tests 时在下方绘出台架试验的回线。
plot-region = { $corner }：工作范围
in-vehicle = 车辆中
rig-tests = 台架试验
vehicle-section = 车辆
vehicle-caption = 仿真所用的车辆。用 --vehicle car.toml 可以给其中任何名称赋予其他数值。
wheel-left = 左
wheel-right = 右
coupling-unstable = 在 { $mass } kg 的车轮上 c h / m 达到 { $moving }（c：力对速度的斜率，h：步长）：力和运动交换有一步延迟的仿真器在大于 1 时不稳定，无延迟时在大于 2 时不稳定；缩短步长有帮助。
coupling-chatter = 在运动中的 { $mass } kg 车轮上 c h / m（c：力对速度的斜率，h：步长）最大为 { $moving }，但在摩擦力换向处（低于 { $slow } mm/s）为 { $all }：那里交换在摩擦力范围内颤振；缩短步长或减小摩擦力的陡度有帮助。
col-near-tests = 接近台架试验，时间的 %
saw-displacement = 位移, mm
saw-velocity = 速度, mm/s

## The workbook.

workbook-contents = 目录
workbook-sheet = 工作表
workbook-about = 内容

## What a fit found.

fit-title = 辨识结果
fit-subtitle = 由 { $data } 中的台架数据得到模型 { $model }
fit-answer = 拟合了 { $tests } 个试验，偏差 { $error }。
quality-sentence = { $grade }：模型与实测力的平均偏差为 { $error } N（最大力的 { $percent } %），{ $beside }；{ $curve }。
quality-noise = 已达到噪声所允许的水平
quality-good = 拟合良好
quality-fair = 拟合一般
quality-poor = 拟合较差
quality-beside-noise = 为记录噪声（{ $noise } N）的 { $ratio } 倍
quality-noise-unknown = 这些记录的噪声未知
quality-curve-worse = 仅用 FV 曲线的偏差为 { $error } N（{ $percent } %），是其 { $ratio } 倍
quality-curve-no-worse = 仅用 FV 曲线的偏差并不更大，为 { $error } N（{ $percent } %）
fit-measured = 测量本身的误差
fit-tests = 用于拟合的试验
remarks = 备注
col-why = 原因
col-interval = 95 % 区间

## Of figures and tables everywhere.

comma = 、
sentence-end = { $sentence }。
semicolon = ；
colon = ：

## The direction that the files count positive.

sign-given = 按给定，文件以{ $direction }为正。
sign-found = 文件以{ $direction }为正（把握 { $percent } %）。
sign-found-by = 文件以{ $direction }为正（把握 { $percent } %）：{ $reasons }。
range = { $low } 至 { $high }
before = 之前
after = 之后

## Figures before and after.

axis-residual = 实测 − 计算, N
axis-residual-rms = 实测 − 计算的均方根, N
axis-resistance = 阻力 实测 − 计算, N
axis-since-reversal = 换向后的时间, ms
axis-error-rms = 误差, N 均方根
plot-error-rms = 各试验的误差, N 均方根
plot-left-velocity = 残差—速度
plot-left-size = 残差大小—速度
plot-left-up = 残差平均值，加速时
plot-left-down = 残差平均值，减速时
plot-left-reversal = 残差平均值，换向之后
plot-left-map = 残差平均值—速度—位移
fitted-tests = 拟合试验
left-out = 留出
stretch = { $test }（{ $count } 段中的第 { $place } 段）

## Diagnosis: title and answer.

diagnosis-title = 模型与记录的偏差所在，以及缺少什么
errors-caption = 每列为一个试验：计算力与实测力相差多少，之前（灰色）和之后（红色）。红点落在横线上表示只剩噪声。留出试验未被任何重新拟合使用：在那里的改进是真实的。
error-unseen = 在任何重新拟合都未使用的 { $tests } 个试验上，误差均方根由 { $before } N 变为 { $after } N
error-fitted = 没有留出试验（试验太少或未指定），因此这些数字说明拟合程度，而不说明预测能力：误差均方根由 { $before } N 变为 { $after } N
gap-is-closed = { $error }；模型与噪声之间的差距缩小了 { $gap }，各试验均以自身噪声为单位计。
nothing-stays = 模型保持不变，仅重新拟合了其数值。
changed-stays = 模型形式不变；其数值现为本减振器的数值。
nothing-added-rivals = 未添加任何内容：在对记录解释得同样好的名称之间猜测毫无价值。下面列出可疑效应以及能够作出判断的试验。
nothing-added-unknown = 未添加任何内容：下面不加名称地描述偏差。其随速度、位移和时间的形状提示应在减振器或试验台上查找什么。
worse-tests = { $all } 个留出试验中有 { $count } 个比之前偏差更大，第一个是 { $test }。
row-before = 之前（原模型，重新拟合）
col-fitted-rms = 拟合试验, N 均方根
col-their-noise = 其噪声, N 均方根
col-left-out-rms = 留出试验, N 均方根
mean-cycles-caption = 针对平均周期，其噪声小于单个周期。误差百分比：试验的 |计算 − 实测| 平均值除以其最大力，再对全部试验取平均。
whole-deviation = 平均 { $error } N（{ $percent } %）
whole-records = 对全部记录的每个采样点（与 dashpot validate 的算法相同）：原模型{ $came }，重新拟合后{ $refitted }，改进后{ $improved }。上面的数字针对平均周期，其中噪声已被平均掉。

## The picture of a diagnosis.

name-and-sure = { $name }（把握 { $sure }）
picture-named = 缺少：{ $names }
picture-nothing = 没有缺少的效应
picture-cannot-tell = 缺少某种效应，但这些记录无法判断是什么
picture-unknown = 存在已知效应都无法解释的缺失
picture-below = 上：试验 { $test }，{ $kind }。下：全部试验。
kind-left-out = 未参与任何重新拟合
kind-fitted = 用于拟合

## Where they disagree.

where-section = 偏差所在
no-region = 没有任何区域高出噪声。
left-map-caption = 实测力减计算力，在各试验到达的每个速度和位移处对全部试验取平均；两幅图使用同一色标。沿零速度的条带为摩擦，沿位移的斜坡为弹簧或气体，相同速度下符号相反为滞后。两个坐标轴都给零附近更多空间。
left-size-caption = 各速度下残差的大小。红线与浅色线重合处只剩噪声。
left-reversal-caption = 换向之后：低于零表示减振器的力比计算建立得晚（柔度、间隙、预滑移、通道滞后），高于零表示阻力更大（起动摩擦）。
speeding-up-caption = 相同速度下，行程加速时……
slowing-down-caption = ……以及减速时。两者不同之处，缺少滞回或滞回过大。
all-there = 到达该处的全部试验
rebound = 复原
compression = 压缩
speeding-up = 加速
slowing-down = 减速
both = 两者
col-direction = 方向
col-speed = 快慢
col-mean-n = 平均, N
col-rms-n = 均方根, N
col-noise-n = 噪声, N
col-in-words = 文字说明
regions-caption = 原模型（重新拟合后）在拟合试验上的实测力减计算力：高出噪声的区域，先列全部试验共有的，再列最差的。

## What is missing.

findings-section = 缺少什么
suspects-section = 可疑效应
suspects-cannot-tell = 缺少其中之一，最可能的在前。
suspects-beside = 此外可能还缺少的，最可能的在前；都不足以添加。
suspects-nearest = 最接近的效应；都不足以确定。
rig-added = 试验台给测量带来：{ $all }。这只在本次对比中修正，不属于改进后的模型；请在下一次试验前调好试验台。
changed-section = 与参考减振器不同的参数
inventory-section = 效应清单
col-force-rms = 力, N 均方根
col-share-of-force = 占力的比例
col-status = 状态
status-kept = 保留
status-added = 新增
status-replaced = 被取代
status-removed = 移除
replaces = 取代{ $effect }
or-instead = 或以 { $effect } 代替（{ $probability }）
inventory-caption = 给定模型与最可能模型的全部效应。效应的力指仅去除该效应时力的变化。
other-effects = 其他效应
plot-inventory = 各效应的力, N 均方根
axis-effect-force = 力, N 均方根
inventory-bands-caption = 区间内参与拟合的各试验的均方根值，首尾相接。反相的力会部分抵消，因此条形可能长于其总和。
shifts-section = 发生变化的模型参数
finding-heading = { $place }. { $effect }{ $form }：把握 { $sure }
finding-form = （{ $form }）
finding-gap = 没有它，差距的 { $gap } 会重新出现。
finding-of-rig = 它属于试验台而非减振器：在对比中修正，不加入模型。
finding-added = 它已加入改进后的模型。
finding-what = { $meaning }。{ $added }{ $gap }
finding-why = 位置：{ $path }（类别：{ $family }，把握 { $family_sure }）。依据：去掉它后 { $share } 的偏差重新出现；它使 { $tests } 的试验残差减小。
rivals-caption = 代替它尝试过的其他效应。
col-parameter = 参数
col-judged = 评价
plausible = 合理
not-plausible = 超出减振器和试验台的常见范围：谨慎对待
col-effect = 效应
col-confidence = 置信度
col-explains = 解释
col-reference = 参考
col-this-damper = 本减振器
changed-caption = 变化按其在试验中产生的力排序。
col-change = 变化
shifts-caption = 没有该效应时，这些参数曾吸收了它的一部分。仅列出变化超过三倍标准差的参数。

## Loops.

loops-section = 改进前后的回线
more-loops-section = 其他试验的回线
loops-about = 之前的偏差占其力比例最大的试验。蓝色为实测平均周期，灰色为对这些试验重新拟合的模型，红色为改进后的模型；第三幅图放大力的残差。
loop-heading = { $test }，{ $kind }
loop-errors = 误差均方根之前 { $before } N，之后 { $after } N；仅噪声为 { $noise } N。{ $closed }
loop-closed = 差距缩小了 { $gap }。

## Errors by amplitude and peak velocity, before and after.

map-before = 之前的误差, 最大力的 %
map-after = 之后的误差, 最大力的 %
map-before-caption = 每个振幅和峰值速度一格；颜色深表示偏差大。
map-after-caption = 加入所发现的效应之后，颜色标度相同。
mean-cycles-rule = 每行中各试验权重相同；百分比相对该行的最大力。为平均周期的误差：噪声小于逐点比较的 dashpot validate。

## Everything that was tried.

tried-section = 全部尝试
tried-about = 每一轮把每个效应的每种形式加入模型，并从多个初值重新拟合全部参数。已确定的效应在该模型中：其各行列在最前，比较有无该效应的模型。解释：超出噪声的均方值中所占比例。剩余误差：对各试验取平均，以噪声和曲线形式所留下的误差为单位。对数几率：加入它后记录的可能性增大多少倍，取自然对数，每个试验计为一个独立样本，并已计入其参数的代价。异常数值：减振器少见的数值所付的代价，单位相同。概率为该效应所有形式的概率。
col-form = 形式
col-probability = 概率
col-error-left = 剩余误差
col-log-odds = 对数几率
col-strange = 异常数值
col-tests-better = 改善的试验
look = 第 { $number } 轮。

## What to measure next.

limits-section = 下一步测量什么
next-tests-section = 值得进行的下一步试验
cannot-show-section = 这些记录无法显示的效应
all-would-show = 任何已知效应都会在这些记录中显现。
col-cannot-show = 原因，以及怎样才能显现
cannot-show-caption = 既未发现，也未排除。
col-next-amplitude = 振幅, mm
col-next-frequency = 频率, Hz
col-next-mean = 平均位置, mm
col-side-force = 侧向力, N
col-difference-rms = 差异, N 均方根
col-what-to-do = 如何进行
next-tests-caption = 差异：各种解释在该处的预测相差多少。该差异明显高于噪声时，试验就能作出判断。

## Parameters of the improved model.

source-refitted = 重新拟合
source-added = 新加入：{ $effect }

## Many dampers.

groups-title = 减振器之间的变化
groups-subtitle = 模型 { $model } 与各组对比；参考：{ $reference }
groups-section = 各组的变化
groups-caption = 各组与参考对比。各试验平均周期上的均方根（N），模型重新拟合：加入名称之前、之后，以及噪声所致。
group-against = { $group }，与 { $reference } 对比
col-group = 组
col-answer = 结论
col-named = 确定的效应
col-before-n = 之前, N
col-after-n = 之后, N
col-group-noise = 噪声, N
no-change = 没有超出区间的变化
not-compared = 未比较：这些记录显示不出
other-groups = 其他组
plot-group-curves = 各组的 FV 曲线
group-curves-caption = 各减振器匀速运动时的力，含摩擦和气体力，绘至其试验所及之处；虚线为参考。
numbers-section = 发生变化的参数
numbers-caption = 至少在一个组中与参考的差异超出两者不确定度的模型参数。
col-quantity = 参数
measurement-section = 测量本身
aside-section = 未分组
aside = 不属于任何组的试验：{ $tests }。
without-test = 分组列表中在数据里找不到对应试验的行：{ $tests }。

# Names of effects, elements and parameters are short, and without commas, since they stand in lists.

## Names. Effects and elements.

name-fv-curve = FV 曲线
name-gas-preload = 恒定气体力
name-gas-spring = 气体弹簧
name-coulomb-friction = 干摩擦
name-stribeck-friction = 带起动峰值的摩擦
name-presliding-friction = 预滑移摩擦
name-viscous-friction = 黏性摩擦
name-side-force-friction = 侧向力引起的摩擦
name-series-compliance = 串联柔度
name-bushing = 橡胶衬套
name-parallel-spring = 并联弹簧
name-oil-compressibility = 油液可压缩性
name-aeration = 油中含气
name-cavitation = 空化
name-gas-warming = 气体力随温度的变化
name-temperature-fade = 温升衰减
name-position-dependent-damping = 位置相关阻尼
name-bump-stop = 压缩限位
name-rebound-stop = 复原限位
name-free-play = 间隙
name-frequency-selective-damping = 频率选择阻尼
name-valve-hysteresis = 阀滞后
name-moving-mass = 运动质量
name-lagged-polynomial = 带滞后的多项式
name-integration = 积分设置
name-cylinder-expansion = 缸筒膨胀

## Names. Effects of the rig, and what looks like something that has no name.

name-channel-delay = 力通道延迟
name-force-offset = 力传感器零点误差
name-force-drift = 力传感器零点漂移
name-gain-drift = 力通道增益漂移
name-load-dependent-friction = 随载荷增大的摩擦
name-load-cell-hysteresis = 力传感器滞后
name-resonance = 共振

## Names. Their numbers.

name-delay = 延迟
name-rig-mass = 力传感器上的质量
name-offset = 零点误差
name-drift = 漂移
name-whole-drift = 总漂移
name-share = 比例
name-share-across = 正交比例
name-share-growth = 比例的增长
name-cooling-rate = 冷却速率

## Names. Parts of the FV curve that change as one.

name-rebound-curve = 复原力
name-compression-curve = 压缩力
name-rebound-low-speed = 低速复原力
name-compression-low-speed = 低速压缩力
name-rebound-high-speed = 高速复原力
name-compression-high-speed = 高速压缩力

## Names. The FV curve.

name-fv-form = FV 曲线的形式
name-fv-interpolation = FV 曲线的插值
name-fv-velocity = FV 曲线的速度
name-fv-force = FV 曲线的力
name-fv-rebound-c1 = 复原第一斜率
name-fv-rebound-c2 = 复原第二斜率
name-fv-rebound-c3 = 复原第三斜率
name-fv-rebound-v1 = 复原第一拐点
name-fv-rebound-v2 = 复原第二拐点
name-fv-compression-c1 = 压缩第一斜率
name-fv-compression-c2 = 压缩第二斜率
name-fv-compression-v1 = 压缩拐点

## Names. In series.

name-series-stiffness = 串联刚度
name-series-damping = 串联阻尼
name-internal-mass = 内部质量
name-series-load = 串联弹簧的载荷
name-free-play-gap = 间隙大小
name-free-play-load = 间隙处的载荷
name-free-play-force = 接触柔软度
name-bushing-hardening = 橡胶硬化
name-bushing-loss-stiffness = 橡胶动态增刚
name-bushing-loss-time = 橡胶松弛时间
name-bushing-slip = 橡胶滑移量
name-bushing-stop = 橡胶到限位的行程
name-bushing-stop-stiffness = 橡胶限位刚度
name-bushing-slow-stiffness = 橡胶慢速增刚
name-bushing-slow-time = 橡胶慢速松弛时间

## Names. Oil.

name-oil-stiffness = 油柱刚度
name-oil-shortening = 油柱缩短率
name-oil-chambers = 受压变形的腔
name-oil-compression = 压缩与复原油柱刚度比
name-aeration-stroke = 空气吸收的行程
name-aeration-force = 压缩空气所需的力
name-aeration-compression = 压缩侧空气行程比
name-cavitation-force = 空化限力
name-cavitation-side = 发生空化的行程
name-cavitation-return = 返程保留的力
name-cavitation-form = 空化的形式
name-cavitation-velocity = 底阀极限速度
name-cavitation-unfilled = 未补充的比例
name-lost-stroke = 空行程
name-cavitation-onset = 空化起点
name-cavitation-expansion = 空穴膨胀

## Names. Over the stroke.

name-bypass-share = 区域内缺失的比例
name-bypass-centre = 区域中点
name-bypass-half-width = 区域半宽
name-bypass-blend = 区域过渡长度
name-bypass-strokes = 区域起作用的行程
name-bypass-form = 区域的形式
name-bypass-flow = 沟槽流量

## Names. Heat.

name-fade-source = 温度来源
name-fade-coefficient = 每开尔文的下降
name-fade-reference = 参考温度
name-heat-capacity = 热容
name-heat-transfer = 每开尔文散热
name-fade-laminar-force = 层流限力
name-fade-slackening = 下降趋缓系数

## Names. Valves.

name-fsd-form = 频率相关的形式
name-fsd-share = 快速行程损失比例
name-fsd-time = 快慢分界时间
name-fsd-velocity = 控制腔充满速度
name-fsd-flow = 旁通流量
name-fsd-force = 控制腔充液力
name-fsd-laminar-force = 旁通层流限力
name-valve-hysteresis-share = 阀滞后比例
name-valve-opening-force = 阀开启力
name-valve-closing-ratio = 关闭与开启力之比
name-valve-time = 阀动作时间
name-valve-width = 阀开启范围
name-valve-form = 阀滞后的形式
name-valve-play = 阀间隙
name-valve-damping = 阀阻尼比

## Names. Springs.

name-spring-linear = 线性刚度
name-spring-quadratic = 二次刚度
name-spring-cubic = 三次刚度
name-spring-quartic = 四次刚度
name-spring-displacement = 弹簧表的位移
name-spring-force = 弹簧表的力

## Names. Friction.

name-coulomb-force = 摩擦力
name-coulomb-steepness = 摩擦换向陡度
name-stribeck-form = Stribeck 形式
name-stribeck-breakaway-force = 起动力
name-stribeck-coulomb-force = 起动后的摩擦力
name-stribeck-breakaway-velocity = 起动速度
name-stribeck-velocity = Stribeck 速度
name-stribeck-fall = 下降指数
name-stribeck-rise = 峰值高度
name-stribeck-rise-power = 上升指数
name-viscous-coefficient = 黏性系数
name-side-force-coefficient = 单位侧向力的摩擦
name-side-force-steepness = 侧向力摩擦陡度
name-presliding-force = 预滑移摩擦力
name-presliding-length = 预滑移位移
name-presliding-power = 预滑移形状
name-presliding-return = 换向后的回弹
name-presliding-creep = 蠕动速度

## Names. Gas.

name-gas-force = 气体力
name-gas-warming-rate = 每开尔文的气体力增量
name-gas-warming-reference = 气体力参考温度
name-gas-stiffness = 气体刚度
name-gas-length = 气柱长度
name-gas-adiabatic-index = 绝热指数
name-gas-thermal-time = 气体热时间

## Names. The model of the literature.

name-polynomial = 多项式系数
name-lag-slow = 低速滞后
name-lag-fast = 高速滞后
name-lag-v1 = 滞后的低速界
name-lag-v2 = 滞后的高速界

## Names. Masses and stops.

name-moving-mass-time = 运动质量的滞后
name-moving-mass-place = 运动质量的位置
name-bump-stop-clearance = 到压缩限位的行程
name-bump-stop-stiffness = 压缩限位刚度
name-bump-stop-progression = 压缩限位渐进深度
name-bump-stop-loss = 压缩限位损失
name-bump-stop-damping = 压缩限位阻尼
name-bump-stop-flow = 压缩限位流动形式
name-rebound-stop-clearance = 到复原限位的行程
name-rebound-stop-stiffness = 复原限位刚度
name-rebound-stop-progression = 复原限位渐进深度
name-rebound-stop-loss = 复原限位损失
name-rebound-stop-damping = 复原限位阻尼
name-rebound-stop-flow = 复原限位流动形式

## Names. The step.

name-method = 积分方法
name-substeps = 子步数

## Choices of a parameter: they stand in a list of a narrow panel.

choice-automatic = 自动
choice-both = 两者
choice-bypass = 旁通
choice-cap = 力限幅
choice-compression = 压缩
choice-cubic-each-side = 分侧三次
choice-driven-end = 驱动端
choice-elastic = 弹性回复
choice-euler = 欧拉法
choice-factor = 系数
choice-filter = 滤波
choice-foot-valve = 底阀
choice-fourth-order = 四阶
choice-full = 完整
choice-gap = 间隙
choice-groove = 沟槽
choice-hydraulic = 液压力
choice-inside = 内部
choice-linear = 线性
choice-measured = 实测
choice-monotone-cubic = 单调三次
choice-opening = 开口
choice-orifice = 节流孔
choice-piecewise = 分段
choice-play = 阀芯摩擦
choice-rebound = 复原
choice-second-order = 二阶
choice-self-heating = 自发热
choice-simplified = 简化
choice-slips = 立即滑移
choice-spool = 阀芯质量
choice-stroke = 每个行程内
choice-table = 表格
choice-third-order = 三阶
choice-three-stage = 三级
choice-whole = 全部力

## What elements and effects are. Names of forms such as `bypass` stand in model files and are not translated.

element-fv-curve = 主减振器：力—速度（FV）曲线
element-series-compliance = 串联弹簧和阻尼及内部质量（气体、油液和支座的可压缩性）
element-free-play = 吊环或支座中的间隙；需要 series_compliance
element-bushing = 与减振器串联的橡胶：串联弹簧变硬并耗散能量；需要 series_compliance
element-oil-compressibility = 阀前油柱的可压缩性（含缸筒膨胀）
element-aeration = 油中有空气：力小时油柱偏软
element-cavitation = 空化：一个行程方向的液压力被限制，留下的空穴需要先闭合
element-position-dependent-damping = 在部分行程上较弱（旁通）或较强的阻尼
element-temperature-fade = 随油温（实测或自身发热）下降的阻尼
element-frequency-selective-damping = 速度相同时，高频行程中的阻尼弱于低频行程
element-valve-hysteresis = 卸荷阀开得晚、关得晚：速度上升时力较大
element-parallel-spring = 与主减振器并联的弹簧：线性、二次、三次、四次或查表
element-coulomb-friction = 恒定水平的干摩擦，F_s tanh(K v)
element-stribeck-friction = 带起动峰值的干摩擦
element-viscous-friction = 黏性摩擦，F_v v|v|
element-side-force-friction = 与侧向力成正比的干摩擦
element-gas-preload = 恒定气体力
element-gas-warming = 随减振器温度增大的气体力
element-lagged-polynomial = 多项式 FV 曲线，带一阶滞后，其时间常数随速度变化
element-presliding-friction = 每次换向后在短位移内反转的摩擦（Dahl）
element-gas-spring = 气体力随活塞杆位移的增长，由慢到快
element-moving-mass = 由驱动端（力传感器与减振器之间）或活塞带动的质量
element-bump-stop = 压缩行程末端的限位，橡胶或液压
element-rebound-stop = 复原行程末端的限位，橡胶或液压
element-integration = 定步长积分的设置
element-channel-delay = 力通道滞后于运动通道（试验台）
element-force-offset = 力传感器无载荷时不为零（试验台）
element-force-drift = 力传感器零点随时间漂移（试验台）

## What parameters mean.

parameter-fv-form = FV 曲线取自表格，或由斜率和拐点给出
parameter-fv-interpolation = FV 表在各点之间的走向
parameter-fv-velocity = FV 表的速度，复原为正，递增
parameter-fv-force = FV 表的力，拉力为正，不递减
parameter-fv-rebound-c1 = Cr1：第一拐点以下的复原斜率
parameter-fv-rebound-c2 = Cr2：两拐点之间的复原斜率
parameter-fv-rebound-c3 = Cr3：第二拐点以上的复原斜率
parameter-fv-rebound-v1 = 复原第一拐点
parameter-fv-rebound-v2 = 复原第二拐点
parameter-fv-compression-c1 = Cc1：拐点以下的压缩斜率
parameter-fv-compression-c2 = Cc2：拐点以上的压缩斜率
parameter-fv-compression-v1 = 压缩拐点，以速率计
parameter-series-stiffness = 串联弹簧刚度，k_s
parameter-series-damping = 串联弹簧旁的阻尼，c_s
parameter-internal-mass = 活塞杆、油液和气体的运动质量，m
parameter-series-load = 串联弹簧承受的力：作用于质量的液压力和弹簧力，或者还包括摩擦力和气体力（如吊环或支座）
parameter-free-play-gap = 从一侧接触到另一侧接触的自由行程，2 g
parameter-free-play-force = 间隙闭合一半时的力，F_0：接触的柔软程度
parameter-free-play-load = 间隙中点处的力，F_1：吊环上的重量、所承受的气体力、夹紧力
parameter-bushing-hardening = 串联弹簧力达到线性值两倍时的变形，d_h
parameter-bushing-loss-stiffness = 快速或小幅运动所增加的刚度占串联刚度的比例，k_1/k_s
parameter-bushing-loss-time = 该部分松弛的时间，tau
parameter-bushing-slip = 该部分因摩擦松弛的变形，d_f；很大时仅随时间松弛
parameter-bushing-stop = 橡胶在任一侧碰到限位时的变形，L
parameter-bushing-stop-stiffness = 限位所增加的刚度占串联刚度的比例，k_e/k_s；0：无限位
parameter-bushing-slow-stiffness = 缓慢松弛的刚度占串联刚度的比例，k_2/k_s
parameter-bushing-slow-time = 该部分松弛的时间，tau_2
parameter-oil-stiffness = x = 0 处油柱刚度（含缸筒膨胀），k_o
parameter-oil-shortening = x = 0 处油柱长度的倒数，lambda；0：各处刚度相同
parameter-oil-chambers = 哪一油柱变形：复原腔的，或受压腔的
parameter-oil-compression = 压缩时油柱刚度与复原时之比，r_o
parameter-aeration-stroke = 复原时空气吸收的行程，d_a
parameter-aeration-force = 该行程被吸收一半时的力，F_a
parameter-aeration-compression = 压缩时空气吸收的行程与复原时之比，r_a
parameter-cavitation-force = 该行程方向的最大液压力，C
parameter-cavitation-side = 力被限制的行程方向
parameter-cavitation-return = 返程中空穴闭合时保留的限力比例：1 气体继续推，0 空行程
parameter-cavitation-form = 空穴来自该行程的限力，或来自底阀未能补充其后的腔室
parameter-cavitation-velocity = 底阀：超过该速度腔室不再被充满，v_f
parameter-cavitation-unfilled = 底阀：超过该速度的流量中缺失的比例，a
parameter-cavitation-onset = 限力：空穴在其多大比例时出现，alpha；1：恰在限力处
parameter-cavitation-expansion = 限力：空穴中气体膨胀、获得其余一半力时的空穴长度，e_1
parameter-bypass-share = 区域内缺失的 FV 力比例，a；负值：较强的区域
parameter-bypass-centre = 区域中点的位移，c
parameter-bypass-half-width = 区域长度的一半，w
parameter-bypass-blend = 区域过渡的长度，b
parameter-bypass-strokes = 起作用的行程方向
parameter-bypass-form = FV 力的系数，或阀旁的流量
parameter-bypass-flow = 槽：区域内液压力为 1 kN 时旁流所对应的活塞速度，q_b
parameter-fade-source = 温度取给定值，或环境温度加减振器自身发热的温升
parameter-fade-coefficient = 每开尔文阻尼的下降，alpha
parameter-fade-reference = FV 曲线的温度，T_0
parameter-heat-capacity = 油液和壳体的热容，C_h
parameter-heat-transfer = 每开尔文向环境的散热，h
parameter-fade-laminar-force = 一半仍为层流并衰减时的力，F_l；很大时全部衰减
parameter-fade-slackening = 每开尔文的下降变小的快慢，kappa；0：指数，1/(T_0 + 95 degC)：Vogel 定律
parameter-fsd-form = 滞后的部分、在每个行程内恢复的部分，或在每个行程内终止的阀旁流量
parameter-fsd-share = 快速行程损失的力的比例，a
parameter-fsd-time = 区分快慢的时间，tau
parameter-fsd-velocity = stroke 形式：充满控制腔的速度，u_0
parameter-fsd-flow = bypass 形式：液压力为 1 kN 时旁流所对应的活塞速度，q_s
parameter-fsd-force = bypass 形式：超过该液压力控制腔以全速充满，F_0
parameter-fsd-laminar-force = bypass 形式：低于该液压力时其流动为层流，F_l
parameter-valve-hysteresis-share = opening 形式：滞后所增加的力的比例，eta
parameter-valve-opening-force = 阀开启时的力
parameter-valve-closing-ratio = opening 形式：关闭力与开启力之比；1：仅由时间造成滞后
parameter-valve-time = 其运动的时间，tau；滑阀：振荡周期除以 2 pi
parameter-valve-width = 开启过程所经历的力的范围，b
parameter-valve-form = 一次开启得晚、关闭得晚，或在任何开度下因摩擦或自身质量而滞后的阀
parameter-valve-play = play 形式：阀不跟随的力，P
parameter-valve-damping = spool 形式：阻尼比，zeta
parameter-spring-linear = k_p x 中的 k_p
parameter-spring-quadratic = k_p x|x| 中的 k_p
parameter-spring-cubic = k_p x^3 中的 k_p
parameter-spring-quartic = k_p x^3|x| 中的 k_p
parameter-spring-displacement = 查表弹簧的位移，递增；空：不查表
parameter-spring-force = 查表弹簧的力，不递减
parameter-coulomb-force = 摩擦力水平，F_s
parameter-coulomb-steepness = 换向的陡度，K
parameter-stribeck-form = 两种 Stribeck 形式中的哪一种
parameter-stribeck-breakaway-force = 峰值（过渡）力，F_brk 或 F_t
parameter-stribeck-coulomb-force = 峰值之后的水平，F_c 或 F_s
parameter-stribeck-breakaway-velocity = 峰值处的速度，v_brk 或 V_fs
parameter-stribeck-velocity = 完整形式：下降的速度尺度，V_s
parameter-stribeck-fall = 完整形式：下降的指数，a（1 Tustin，2 Gauss）
parameter-stribeck-rise = 完整形式：峰值接近 F_t 的程度，c
parameter-stribeck-rise-power = 完整形式：上升的指数，d
parameter-viscous-coefficient = F_v v|v| 中的 F_v
parameter-side-force-coefficient = 单位侧向力的摩擦力，k_avg
parameter-side-force-steepness = 换向的陡度，K
parameter-gas-force = 气体力，把活塞杆推出为正
parameter-gas-warming-rate = 每开尔文的气体力增量，c
parameter-gas-warming-reference = 气体力等于其他元件给出值时的温度，T_0
parameter-polynomial = v^0、v^1、... 的系数
parameter-lag-slow = 低速时的时间常数
parameter-lag-fast = 高速时的时间常数
parameter-lag-v1 = 时间常数开始变化的速度
parameter-lag-v2 = 时间常数变化完毕的速度
parameter-presliding-force = 长位移之后的摩擦力水平，F_c
parameter-presliding-length = 力以因子 e 接近其水平所需的位移，z_0
parameter-presliding-power = 1：一开始就滑动（Dahl）；更大：先弹性变形再滑动，n
parameter-presliding-return = 换向之后，变形的接触立即滑动，或先弹回
parameter-presliding-creep = 低于该速度时接触蠕动，v_c
parameter-gas-stiffness = x = 0 处的慢速（等温）刚度，k
parameter-gas-length = x = 0 处气体体积与活塞杆面积之比，L：变硬的快慢
parameter-gas-adiabatic-index = 快速与慢速刚度之比，gamma
parameter-gas-thermal-time = 气体达到壁温所需的时间，tau
parameter-moving-mass = 质量，M
parameter-moving-mass-time = 其力滞后的时间，tau；与运动相比很短
parameter-moving-mass-place = 由什么带动：驱动端，或串联刚度后的活塞
parameter-bump-stop-clearance = 从 x = 0 起压缩到碰到限位的长度，取正值
parameter-bump-stop-stiffness = 初始接触时的刚度
parameter-bump-stop-progression = 弹簧力达到线性弹簧两倍时的深度
parameter-bump-stop-loss = 压入和退出时各损失的弹簧力比例
parameter-bump-stop-damping = 压入时、渐进深度处的液压阻尼
parameter-bump-stop-flow = 液压力与速度成正比，或与其平方成正比（1 m/s 时相同）
parameter-rebound-stop-clearance = 从 x = 0 起伸长到碰到限位的长度
parameter-rebound-stop-stiffness = 初始接触时的刚度
parameter-rebound-stop-progression = 弹簧力达到线性弹簧两倍时的深度
parameter-rebound-stop-loss = 压入和退出时各损失的弹簧力比例
parameter-rebound-stop-damping = 压入时、渐进深度处的液压阻尼
parameter-rebound-stop-flow = 液压力与速度成正比，或与其平方成正比（1 m/s 时相同）
parameter-method = 步内方法；automatic：使 1 ms 步长误差低于千分之一的最省方法
parameter-substeps = 主机一步内的子步数；0：按模型刚度与阻尼所需
