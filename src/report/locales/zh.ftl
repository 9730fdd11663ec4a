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
matrix-about = 每一行以其全部试验（包括其他设置下的试验）的最大力为百分比基准。每个单元格是其各试验的平均值，每个试验以其自身的最大力为基准，与试验图相同。因此含有较弱试验的行可能低于其单元格。
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
family-between = 作为检验留出 { $at } 时，未见过它的模型族预测误差为 { $error } N（{ $percent } %），是单独拟合 { $at } 的 { $ratio } 倍。
family-between-worse = 模型在各设置之间不确定。作为检验留出 { $at } 时，未见过它的模型族预测误差为 { $error } N（{ $percent } %），是单独拟合 { $at } 的 { $ratio } 倍。模型本身包含 { $at }。{ $advice }
family-between-records = 在 { $at } 与相邻设置之间测量最有帮助。
family-between-labels = 请先检查有疑问的试验设定值。
family-between-unknown = 无法留出任何设定值，因此设定值之间的误差未知；第三个设定值可以显示该误差。
family-about = 该减振器取决于一个设置。每个试验取其自身的设置；模型文件各设置之间采用插值。
family-interpolated = { $setting }（插值）
plot-family = 各设置下恒定速度时的力
family-caption = 模型文件的每个设置一条曲线，其间的试验设置用虚线表示。圆点为峰值速度下的实测力，颜色与其设置相同。
family-table = 各设置下试验的平均值。FV 曲线由该设置的试验拟合。各试验以其自身的最大力为百分比基准。
family-clamped = { $setting }（截断）
family-errors-section = 各设置下的误差
family-left-out-table = 拟合试验平均循环上的平均误差。去掉某一设置的系列由其余设置重新拟合并插值；网格两端没有此值。各试验以其自身的最大力为百分比基准。单独拟合某一设置时 FV 曲线的点较少，因此系列可能更好。
family-own-fit = 单独拟合
family-fit = 系列
family-without = 去掉它的系列
col-ratio = 比值
family-loops-section = 各设置的回线
family-loops-about = 具有该运动的各设置下的同一运动：幅值 { $amplitude } mm，峰值速度 { $velocity } mm/s。
family-worst-about = 以下为各设置下百分比误差最大的试验。
family-worst-caption = { $setting }：{ $test }，平均误差 { $error } N，{ $percent } %
plot-surface = 力随速度与设置的变化
surface-caption = 模型在恒定速度下的力。彩色线为模型文件的各设置，灰色线为恒定速度及其间的设置。圆点为峰值速度下的实测力。
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
responses-late = 模型未能跟随所有阶跃。其力达到 63 % 比实测晚（+）或早（−），差值超过测量的不确定度：{ $steps }。
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
undecided = 未定
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
certificate-unsure = { $verdict }，但不确定：测得时间的不确定度为 ± { $value } ms
certificate-damping = { $verdict }；其中 { $value } N 随速度增长，属于阻尼
certificate-interpolated = { $tests }，插值
certificate-step = 从 { $from } 到 { $to } 的阶跃：{ $tests }
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
quality-beyond-noise = 为记录噪声（{ $noise } N）的 { $ratio } 倍，即试验中有模型未包含的现象
quality-noise-unknown = 这些记录的噪声未知
quality-curve-worse = 仅用 FV 曲线的偏差为 { $error } N（{ $percent } %），是其 { $ratio } 倍
quality-curve-no-worse = 仅用 FV 曲线时偏差大致相同或更小，为 { $error } N（{ $percent } %）
quality-worst = 按百分比最差的试验是 { $test }：平均 { $error } N（该试验最大力的 { $percent } %；仅用 FV 曲线为 { $curve } N）。
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
rating-left-out = { $grade }：在留出的试验上，模型与实测力相差 { $error } N（均方根），为其噪声的 { $ratio } 倍。
rating-fitted = { $grade }：在参与拟合的试验上，模型与实测力相差 { $error } N（均方根），为其噪声的 { $ratio } 倍。
gap-is-closed = { $error }；模型与噪声之间的差距缩小了 { $gap }，各试验均以自身噪声为单位计。
gap-grows = { $error }；模型与噪声之间的差距增大了 { $gap }，各试验均以自身噪声为单位计。
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
whole-records-refitted = 对全部记录的每个采样点（与 dashpot validate 的算法相同）：原模型{ $came }，重新拟合后{ $refitted }。上面的数字针对平均周期，其中噪声已被平均掉。
whole-records-other = 原模型与这些记录相差 { $came }；重新拟合后相差 { $refitted }。因此它描述的是另一支减振器、另一设定或另一温度，其参数已改变。

## The picture of a diagnosis.

name-and-sure = { $name }（把握 { $sure }）
picture-named = 该减振器表现出：{ $names }
picture-nothing = 没有缺少已知效应
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
status-added-unnamed = 新增，未命名
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
finding-disagreement = 去掉它后 { $gap } 的偏差重新出现。
finding-of-rig = 它属于试验台而非减振器：在对比中修正，不加入模型。
finding-added = 它已加入改进后的模型。
finding-what = { $meaning }。{ $added }{ $gap }
finding-why = 位置：{ $path }（类别：{ $family }，把握 { $family_sure }）。加入它后，{ $tests } 的试验残差减小。
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
loop-grown = 差距增大了 { $gap }。

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
group-note = { $groups }：{ $text }
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
numbers-caption = 至少在一个组中与参考的差异超出两者不确定度的模型参数。其下为已确定效应的数值。
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
name-share = 比值
name-share-across = 正交比值
name-share-growth = 比值的增长
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
name-oil-chambers = 可压缩的腔室
name-oil-compression = 压缩与复原油柱刚度比
name-aeration-stroke = 空气吸收的行程
name-aeration-force = 压缩空气所需的力
name-aeration-compression = 压缩侧空气行程比
name-cavitation-force = 空化限力
name-cavitation-side = 发生空化的行程
name-cavitation-return = 返程保留的力
name-cavitation-form = 空化的形式
name-cavitation-velocity = 底阀极限速度
name-cavitation-unfilled = 未补充的流量比例
name-lost-stroke = 空行程
name-cavitation-onset = 空化起点
name-cavitation-expansion = 空穴膨胀

## Names. Over the stroke.

name-bypass-share = 区域内力的减小比例
name-bypass-centre = 区域中点
name-bypass-half-width = 区域半宽
name-bypass-blend = 区域过渡长度
name-bypass-strokes = 区域起作用的行程
name-bypass-form = 区域的形式
name-bypass-flow = 沟槽流量

## Names. Heat.

name-fade-source = 温度来源
name-fade-coefficient = 每开尔文的阻尼下降
name-fade-reference = 参考温度
name-heat-capacity = 热容
name-heat-transfer = 每开尔文的热流
name-fade-laminar-force = 层流限力
name-fade-slackening = 下降率的温度依赖

## Names. Valves.

name-fsd-form = 频率相关的形式
name-fsd-share = 高频力损失比例
name-fsd-time = 频率相关的时间常数
name-fsd-velocity = 控制腔充满速度
name-fsd-flow = 旁通流量
name-fsd-force = 控制腔充液力
name-fsd-laminar-force = 旁通层流限力
name-valve-hysteresis-share = 阀滞后所增加的力的比例
name-valve-opening-force = 阀开启力
name-valve-closing-ratio = 关闭与开启力之比
name-valve-time = 阀的时间常数
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
name-stribeck-rise = 上升陡度
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
choice-driven-end = 运动端
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
element-series-compliance = 串联弹簧和阻尼及内部质量：气体、油液和支座的柔度
element-free-play = 吊环或支座中的间隙；需要 series_compliance
element-bushing = 与减振器串联的橡胶衬套：渐硬且有迟滞的弹簧；需要 series_compliance
element-oil-compressibility = 阀前油柱的可压缩性，含缸筒膨胀
element-aeration = 油中的游离空气：力小时油柱刚度低
element-cavitation = 空化：一个行程产生空穴，返程须先将其闭合
element-position-dependent-damping = 位置相关阻尼：在部分行程上较低（旁通）或较高
element-temperature-fade = 温度衰退：阻尼随油温下降，油温取实测值或由自身发热计算
element-frequency-selective-damping = 频率选择阻尼：速度相同时，行程频率高时的阻尼低于频率低时
element-valve-hysteresis = 开启和关闭均滞后的卸荷阀：速度上升时力较大
element-parallel-spring = 与主减振器并联的弹簧：线性、二次、三次、四次或查表
element-coulomb-friction = 库仑摩擦：大小恒定的干摩擦，F_s tanh(K v)
element-stribeck-friction = Stribeck 摩擦：带起动峰值的干摩擦
element-viscous-friction = 黏性摩擦，与速度的平方成正比，F_v v|v|
element-side-force-friction = 与活塞杆侧向力成正比的干摩擦
element-gas-preload = 恒定气体力
element-gas-warming = 随减振器温度增大的气体力
element-lagged-polynomial = 多项式 FV 曲线，带一阶滞后，其时间常数随速度变化
element-presliding-friction = 预滑动摩擦（Dahl）：每次换向后在短位移内变号
element-gas-spring = 气体力随活塞杆位移的变化，由等温到绝热
element-moving-mass = 由运动端带动的质量（力传感器与减振器之间）或由活塞带动的质量的惯性
element-bump-stop = 压缩行程末端的缓冲限位，橡胶或液压
element-rebound-stop = 复原行程末端的缓冲限位，橡胶或液压
element-integration = 定步长积分的设置
element-channel-delay = 力通道滞后于运动通道（试验台）
element-force-offset = 力传感器无载荷时不为零（试验台）
element-force-drift = 力传感器零点随时间漂移（试验台）

## What parameters mean.

parameter-fv-form = FV 曲线的来源：表格，或阻尼系数和拐点速度
parameter-fv-interpolation = FV 表各点之间的插值
parameter-fv-velocity = FV 表的速度，复原为正，递增
parameter-fv-force = FV 表的力，拉力为正，不递减
parameter-fv-rebound-c1 = Cr1：第一拐点以下的复原阻尼系数
parameter-fv-rebound-c2 = Cr2：两拐点之间的复原阻尼系数
parameter-fv-rebound-c3 = Cr3：第二拐点以上的复原阻尼系数
parameter-fv-rebound-v1 = 复原第一拐点的速度
parameter-fv-rebound-v2 = 复原第二拐点的速度
parameter-fv-compression-c1 = Cc1：拐点以下的压缩阻尼系数
parameter-fv-compression-c2 = Cc2：拐点以上的压缩阻尼系数
parameter-fv-compression-v1 = 压缩拐点处的速率，取正值
parameter-series-stiffness = 串联弹簧刚度，k_s
parameter-series-damping = 与串联弹簧并联的阻尼系数，c_s
parameter-internal-mass = 活塞杆、油液和气体的内部运动质量，m
parameter-series-load = 串联弹簧承受的力：液压力和并联弹簧力，或者还包括摩擦力和气体力（吊环或支座）
parameter-free-play-gap = 从一侧接触到另一侧接触的总间隙，2 g
parameter-free-play-force = 接触柔度：使间隙闭合一半的力（在 F_1 之外），F_0
parameter-free-play-load = 间隙中点处的载荷，F_1：吊环上的重量、气体力、夹紧力
parameter-bushing-hardening = 渐硬使串联弹簧力加倍时的变形，d_h
parameter-bushing-loss-stiffness = 快速松弛（Maxwell）支路刚度与串联刚度之比，k_1/k_s
parameter-bushing-loss-time = 快速支路的松弛时间，tau
parameter-bushing-slip = 填料摩擦使快速支路松弛的变形，d_f；很大时仅随时间松弛
parameter-bushing-stop = 橡胶在任一方向碰到限位时的变形，L
parameter-bushing-stop-stiffness = 限位增加的刚度与串联刚度之比，k_e/k_s；0：无限位
parameter-bushing-slow-stiffness = 缓慢松弛（Maxwell）支路刚度与串联刚度之比，k_2/k_s；0：无此支路
parameter-bushing-slow-time = 缓慢支路的松弛时间，tau_2
parameter-oil-stiffness = x = 0 处油柱刚度（含缸筒膨胀），k_o
parameter-oil-shortening = x = 0 处油柱长度的倒数，lambda；0：刚度与位置无关
parameter-oil-chambers = 油柱可压缩的腔室：始终为复原腔，或受压腔
parameter-oil-compression = 压缩与复原时油柱刚度之比，r_o
parameter-aeration-stroke = 复原时空气压缩所吸收的行程，d_a
parameter-aeration-force = 空气已吸收其一半行程时的力，F_a
parameter-aeration-compression = 压缩与复原时空气吸收的行程之比，r_a
parameter-cavitation-force = 空化行程上的最大液压力，C
parameter-cavitation-side = 发生空化的行程
parameter-cavitation-return = 返程中空穴闭合时作用的力与 C 之比；1：气体仍在推，0：无力
parameter-cavitation-form = 空穴的成因：空化行程上的力受限，或底阀未能补充活塞后的腔室
parameter-cavitation-velocity = 底阀：空化行程的速度超过该值时腔室不能完全补充，v_f
parameter-cavitation-unfilled = 底阀：v_f 以上的流量中未得到补充的比例，a
parameter-cavitation-onset = 限力：空穴出现时的力与 C 之比，alpha；1：恰为 C
parameter-cavitation-expansion = 限力：气体膨胀使力由 alpha C 升至与 C 的中间值时的空穴深度，e_1
parameter-bypass-share = 区域内 FV 力减小的比例，a；负值：增大
parameter-bypass-centre = 区域中心的位移，c
parameter-bypass-half-width = 区域长度的一半，w
parameter-bypass-blend = 区域两端的过渡长度，b
parameter-bypass-strokes = 区域起作用的行程
parameter-bypass-form = FV 力的系数，或与阀并联的旁通流量
parameter-bypass-flow = 槽：区域内液压力为 1 kN 时的旁通流量，以活塞速度计，q_b
parameter-fade-source = 油温：实测值，或环境温度加计算的自身温升
parameter-fade-coefficient = 每开尔文阻尼的相对下降，alpha
parameter-fade-reference = FV 曲线的参考温度，T_0
parameter-heat-capacity = 油液和减振器壳体的热容，C_h
parameter-heat-transfer = 每开尔文温差向环境的热流，h
parameter-fade-laminar-force = 其中一半为层流并衰退的 FV 力，F_l；很大时全部衰退
parameter-fade-slackening = 下降率随温度的变化，kappa；0：指数律，1/(T_0 + 95 degC)：Vogel 定律
parameter-fsd-form = 力中滞后的部分、在每个行程内建立的部分，或在每个行程内终止的旁通流量
parameter-fsd-share = 高频时损失的力的比例，a
parameter-fsd-time = 滞后或充满控制腔的时间常数，tau
parameter-fsd-velocity = stroke 形式：超过该速度控制腔以全速充满，u_0
parameter-fsd-flow = bypass 形式：液压力为 1 kN 时的旁通流量，以活塞速度计，q_s
parameter-fsd-force = bypass 形式：超过该液压力控制腔以全速充满，F_0
parameter-fsd-laminar-force = bypass 形式：低于该液压力时旁通流动为层流，F_l
parameter-valve-hysteresis-share = opening 形式：滞后所增加的最大力与 FV 力之比，eta
parameter-valve-opening-force = 阀开启时的力
parameter-valve-closing-ratio = opening 形式：关闭力与开启力之比；1：滞后仅来自时间常数
parameter-valve-time = 阀运动的时间常数，tau；spool 形式：固有周期除以 2 pi
parameter-valve-width = 阀开启所经历的力的范围，b
parameter-valve-form = 一次滞后的开启，或阀位在任何力下因摩擦或质量而滞后的阀
parameter-valve-play = play 形式：不使阀移动的力的变化（摩擦），P
parameter-valve-damping = spool 形式：阀的阻尼比，zeta
parameter-spring-linear = 线性刚度，k_p x 中的 k_p
parameter-spring-quadratic = 二次刚度，k_p x|x| 中的 k_p
parameter-spring-cubic = 三次刚度，k_p x^3 中的 k_p
parameter-spring-quartic = 四次刚度，k_p x^3|x| 中的 k_p
parameter-spring-displacement = 弹簧查找表的位移，递增；空：无表
parameter-spring-force = 弹簧查找表的力，不递减
parameter-coulomb-force = 摩擦力的大小，F_s
parameter-coulomb-steepness = 零速处变号的陡度，K
parameter-stribeck-form = Stribeck 曲线的形式
parameter-stribeck-breakaway-force = 起动力（峰值），F_brk 或 F_t
parameter-stribeck-coulomb-force = 峰值之后的库仑摩擦力，F_c 或 F_s
parameter-stribeck-breakaway-velocity = 起动峰值处的速度，v_brk 或 V_fs
parameter-stribeck-velocity = 完整形式：Stribeck 速度，即峰值之后下降的速度尺度，V_s
parameter-stribeck-fall = 完整形式：峰值之后下降的指数，a（1 Tustin，2 Gauss）
parameter-stribeck-rise = 完整形式：升至峰值的陡度，c；很大时峰值达到 F_t
parameter-stribeck-rise-power = 完整形式：升至峰值的指数，d
parameter-viscous-coefficient = 摩擦系数，F_v v|v| 中的 F_v
parameter-side-force-coefficient = 摩擦系数：摩擦力与侧向力之比，k_avg
parameter-side-force-steepness = 零速处变号的陡度，K
parameter-gas-force = 气体力，把活塞杆推出为正
parameter-gas-warming-rate = 每开尔文的气体力增量，c
parameter-gas-warming-reference = 本元件不增加气体力时的温度，T_0
parameter-polynomial = 多项式 FV 曲线中 v^0、v^1、... 的系数
parameter-lag-slow = 低速时滞后的时间常数
parameter-lag-fast = 高速时滞后的时间常数
parameter-lag-v1 = 低于该速度时间常数取低速值
parameter-lag-v2 = 高于该速度时间常数取高速值
parameter-presliding-force = 长位移之后的摩擦力，F_c
parameter-presliding-length = 预滑动位移：与 F_c 之差减小到 37 % 的位移，z_0
parameter-presliding-power = 滑动的指数，n；1：一开始就滑动（Dahl），更大：先弹性变形再滑动
parameter-presliding-return = 换向后的卸载：伴随滑动，或为弹性
parameter-presliding-creep = 低于该速度时接触蠕动，v_c
parameter-gas-stiffness = x = 0 处气体的等温刚度，k
parameter-gas-length = x = 0 处气体体积与活塞杆面积之比，L；越短越渐进
parameter-gas-adiabatic-index = 绝热指数：绝热刚度与等温刚度之比，gamma
parameter-gas-thermal-time = 气体与壁面之间的热时间常数，tau
parameter-moving-mass = 运动质量，M
parameter-moving-mass-time = 惯性力的滞后时间，tau；与运动相比很短
parameter-moving-mass-place = 带动质量的点：减振器的运动端，或串联刚度后的活塞
parameter-bump-stop-clearance = 从 x = 0 压缩到首次接触限位的长度，取正值
parameter-bump-stop-stiffness = 限位在初始接触时的刚度
parameter-bump-stop-progression = 限位弹簧力达到线性值两倍时的限位变形
parameter-bump-stop-loss = 加载时损失的弹簧力比例，卸载时再损失同样比例
parameter-bump-stop-damping = 加载时的液压阻尼系数，取渐进变形处的值
parameter-bump-stop-flow = 液压力与速度成正比（缝隙）或与其平方成正比（节流孔），1 m/s 时相同
parameter-rebound-stop-clearance = 从 x = 0 伸长到首次接触限位的长度
parameter-rebound-stop-stiffness = 限位在初始接触时的刚度
parameter-rebound-stop-progression = 限位弹簧力达到线性值两倍时的限位变形
parameter-rebound-stop-loss = 加载时损失的弹簧力比例，卸载时再损失同样比例
parameter-rebound-stop-damping = 加载时的液压阻尼系数，取渐进变形处的值
parameter-rebound-stop-flow = 液压力与速度成正比（缝隙）或与其平方成正比（节流孔），1 m/s 时相同
parameter-method = 步内的积分方法；automatic：1 ms 步长误差低于千分之一的最省方法
parameter-substeps = 主机一步内的子步数；0：按模型刚度与阻尼所需

# What reading says of records.

## What reading says of records. Lists.

records-comma = 、
records-semicolon = ；
records-quoted = “{ $test }”
records-and-more = { $names } 等，另有 { $count } 个
records-or = 或

## What reading says of records. Files and tables.

records-profile = 按 { $file } 的规定读取
records-stray = { $folder } 中未作为记录读取：{ $names }
records-below = { $folder } 的子文件夹中有 { $count } 个文件未读取（{ $names }）；若它们是同一减振器的试验，--subfolders 会一并读取
records-columns-not-read = 未读取的列：{ $names }
records-by-unit = 仅根据单位将“{ $column }”作为{ $channel }读取；若应为其他列，请用 --column 指定
records-converted = 已换算为国际单位制：{ $channels }
records-from-unit = { $channel }（原单位 { $unit }）
records-time-of-day = 钟点时间自第一行起算
records-one-clock = 各记录按其文件所载的日期和时间放到同一时钟上，从 { $first } 到 { $last }：热量和漂移在文件之间延续
records-dates-assumed = 日期 { $date }（{ $at }）可能日在前或月在前，文件中没有依据可以判断；已读作 { $read }，{ $why }。用 --dates day-first（日在前）或 month-first（月在前）指定（campaign.toml 中的 dates）
records-dates-close = 因为这样各试验的日期相近
records-dates-american = 月在前（美国斜杠写法）
records-dates-usual = 日在前（连字符的通常写法）
records-own-clocks = 每条记录各有自己的时钟，因此热量和漂移不在文件之间延续：{ $why }
records-some-without-date = { $all } 个文件中只有 { $count } 个载有试验开始的时间
records-too-far-apart = 按其文件所载的时间，它们相隔太久，不可能是同一批试验
records-clocks-overlap = 按其文件所载的时间，它们互相重叠；这些时间可能是导出的时间
records-two-rates = 在单独的组中以更高采样率测量，已线性插值到较慢通道的时刻：{ $names }
records-cut-off = 文件在写入时中断，末尾缺少数据；已读取之前完整的 { $rows } 行。若试验本应更长，请重新测量
records-stale-rows = 前 { $count } 行（至第 { $line } 行）属于更早的一次运行，因为其后时间从 { $from } s 退回到 { $to } s；已略去
records-crank = 时间由曲柄转角按每分钟 { $rpm } 转计算得出
records-resampled = 以其他采样率测得，已按直线插值到力与运动的时刻：{ $names }
records-below-heading = 表头下方第 { $line } 行没有数值：{ $text }
records-below-table = 表格下方自第 { $line } 行起未读取：{ $text }
records-between-rows = 数据行之间有 { $count } 行不含数值，已跳过（第 { $lines } 行），首行为：{ $text }
records-behind-rows = { $count } 行在表头各列之后还有文字，未读取（第 { $lines } 行），首处为：{ $text }
records-longer-rows = { $count } 行的数值多于表头的列数，无法确定对应关系；这些行已略去（第 { $lines } 行）。首行多出：{ $text }

## What reading says of records. Gaps in time.

records-of-file = { $file }：{ $text }
records-of-files = { $count } 个文件（{ $names } 等）有同类提示，首个为：{ $text }
records-gaps = 时间有间断：{ $places }{ $more }。按 { $count } 个试验读取{ $rest }
records-gap = { $from } s 之后有 { $seconds } s 无采样（第 { $line } 行）
records-more-gaps = ，另有 { $count } 处
records-too-few-between = ；间断之间的 { $count } 个采样不足以构成一个试验
records-stumps = 间断旁有 { $count } 段不含完整循环，已略去：{ $places }
records-from-to = { $from } 至 { $to } s
records-at-speeds = { $count } 个试验依次进行，均为匀速行程，按速度变化处分开；时钟连续，热量会延续
records-speed-of-strokes = 速度取每个完整行程的速度，因为每个行程的采样点太少，无法得到其变化过程
records-at-settings = { $count } 个试验连续进行，中间没有停顿；在行程或频率改变并保持之处分开；时钟连续，因此热量会延续
records-at-rests = { $count } 个试验前后相接，按静止前后运动的不同在静止处分开；完整循环前后的静止已切除，时钟连续，热量由此延续

## What reading says of records. Rows.

records-overflows = { $channel }通道有 { $count } 个值超出任何传感器的量程，首个为 { $value } { $unit }（第 { $line } 行）；按缺失处理
records-rows-dropped = { $rows } 行中有 { $count } 行因单元格为空或不是数值而舍去（第 { $lines } 行）
records-setting-held = 设定“{ $setting }”的 { $rows } 个值中缺少 { $count } 个；均取其前一个值
records-setting-start = 设定“{ $setting }”在 { $seconds } s 内尚未到达其值；该起始段已剪去
records-setting-empty = 设定“{ $setting }”的列为空：该试验视为没有该设定，或以其名称为准
records-unread-current = 未读取单位为 { $unit } 的列“{ $column }”；若它是减振器阀的电流，请给出 --column current='{ $column }'，否则给出 --ignore current
records-unread-setting = 未读取单位为 { $unit } 的列“{ $column }”；若它是减振器阀的设置，请给出 --column setting='{ $column }'，否则给出 --ignore current
records-small-current = 电流最大为 { $current } mA，按 0 A 计，因为没有阀对此有响应；若该列单位为 A，请给出 --unit current=A
records-filled = { $channel }通道的 { $count } 个缺失值已用直线补齐
records-empty-column = { $channel }通道的列为空，已舍去
records-repeated-rows = { $blocks } 段共 { $count } 行与前面的行及其时间戳重复，首次在第 { $line } 行；已删除
records-repeated-blocks = { $blocks } 段共 { $rows } 行以新的时间戳重复其前面的行（首段：自第 { $line } 行起 { $first } 行）；已删除，其后的时间已前移衔接
records-out-of-order = 时间倒退 { $count } 次，首次在第 { $line } 行；{ $moved } 行已重新排序
records-shared-stamps = { $rows } 行中有 { $count } 行与前一行时间戳相同；已在到下一时间戳之间均匀分布

## What reading says of records. Samples.

records-clipped-motion = { $channel }通道有 { $percent } % 的采样在 { $value } { $unit } 处被削平，首次在第 { $line } 行；该通道已舍去，由{ $other }导出
records-rounded = { $channel }在 { $count } 个采样中停在 { $value } { $unit }，首次在第 { $line } 行；其他试验超过该值，因此视为换向而非量程尽头
records-clipped-force = 力有 { $count } 个采样（{ $percent } %）在 { $value } N 处被削平，首次在第 { $line } 行；这些采样已舍去
records-spiky = { $channel }通道尖峰很多：{ $percent } % 的采样偏离相邻采样；数量过多，不是偶发尖峰，保持原样
records-spikes = { $channel }通道 { $spikes } 个尖峰共 { $count } 个采样已用直线代替，首次在第 { $line } 行，最大偏差 { $largest } { $unit }

## What reading says of records. Motion.

records-consistent = 速度为位移导数的 { $gain } 倍，{ $lag }（位移方差有 { $percent } % 未被解释）
records-no-lag = 无滞后
records-lags = 滞后 { $lag } ms
records-leads = 超前 { $lag } ms
records-differentiated = 速度由位移经局部三次多项式求导得到，窗口 { $points } 个采样（{ $window } s），零相位，−3 dB 在 { $frequency } Hz{ $shorter }
records-shorter = ；运动在窗口内转折处窗口更短，占采样的 { $percent } %
records-integrated = 位移由速度积分得到，起点 { $start } mm；已去除速度零偏 { $offset } mm/s，相当于整个记录漂移 { $drift } mm（{ $basis }）
records-not-periodic-ends = 记录不是周期性的，因此认为减振器终点与起点相同
records-cycles-return = 根据完整循环，每个循环减振器都回到原位

## What reading says of records. What the user knows of the sensors.

records-force-zero = 已按给定值减去力零点 { $force } N
records-gain = 力已按给定值乘以 { $gain }
records-displacement-zero = 已按给定值减去位移零点 { $displacement } mm
records-force-turned = 已按要求反转力的符号
records-motion-turned = 已按要求反转位移和速度的符号
records-gain-of = { $channel }已乘以 { $gain }
records-mass-taken-off = 已按给定值减去力传感器上 { $mass } kg 质量运动所需的力
records-early-as-given = 按给定值，力比运动早 { $delay } ms；已将运动移到该处，力的采样保持原样
records-late-as-given = 按给定值，力比运动晚 { $delay } ms；已将运动移到该处，力的采样保持原样
records-taken-out = 辨识发现的测量偏差已去除

## What reading says of records. Cycles.

records-no-cycles = 未找到完整循环；记录全部保留（{ $samples } 个采样）
records-trimmed = 已剪去首个完整循环之前的静止和起动段 { $before } s（{ $samples_before } 个采样）以及最后一个循环之后 { $after } s（{ $samples_after } 个采样，{ $tail }）；保留 { $cycles } 个循环，{ $frequency } Hz
records-unlike-cycles = 循环之间有 { $places } 处运动不是同样的完整循环（停顿或干扰）；保留在记录中，但不计入循环
records-noisy-last = 最后一个循环（自 { $start } s 起）与其余循环的均方根偏差为 { $last } N，而其余循环之间为 { $typical } N；已舍去
records-displacement-drifts = 平均位移在 { $cycles } 个循环内漂移 { $drift } mm（行程的 { $percent } %）；保持原样
records-force-drifts = 平均力在 { $cycles } 个循环内漂移 { $drift } N（其变化范围的 { $percent } %）；保持原样

## What reading says of records. Figures that no damper has.

records-no-force = 在 { $tests } 中力只有噪声；请检查力传感器，或舍去这些试验
records-small-amplitude = 最大振幅为 { $amplitude } { $unit }：位移单位是否正确？
records-slow = 最快的试验只达到 { $velocity } { $unit }：时间和运动的单位是否正确？仅凭慢速试验，模型对行驶工况一无所知
records-small-force = 力的变化从未超过 { $force } N：其单位是否正确？
records-torn = { $test }：不足一个循环，且在行程中途结束，结束时速度为 { $velocity } mm/s，最大为 { $peak } mm/s；若文件中断，请重新导出，或用 --exclude 排除
records-twins = { $test } 与 { $twin } 的采样相同，被计算两次

## What reading says of records. A force that comes late.

records-late = 力比运动约晚 { $delay } ms：按此计，速度曲线有 { $left } % 的力方差未能解释，按原记录则为 { $recorded } %
records-late-not-moved = { $late }{ $energy }。此处滞回看起来像延迟，因此未作任何移动。dashpot fit 会将两者区分，并报告所发现的延迟；其余为减振器的滞回。仅当已知试验台使力延迟这么多时才给出 { $option }
records-would-feed = ；按原记录，减振器在 { $all } 个试验中有 { $count } 个会输出能量

## What reading says of records. The direction that the files count positive.

records-standstill = 按文件的计数，静止时的力为 { $force } N ± { $error } N；气体将活塞杆推出，这{ $verdict }
records-speaks-for-tension = 说明拉力为正（复原）
records-speaks-for-push = 说明推力为正（压缩）
records-too-small-to-tell = 太小，无法判断方向
records-no-standstill = 没有静止的换向点，因此无法得知气体力
records-asymmetry = 从低速到高速，正速度下力的增量是负速度下的 { $ratio } 倍（误差因子 { $error }）；多数减振器复原阻力更大，这{ $verdict }
records-speaks-for-rebound = 说明复原为正
records-speaks-for-compression = 说明压缩为正
records-tells-nothing = 不说明问题
records-contradict = 气体力与不对称性相互矛盾；已采用其中较强者
records-not-dissipating = 没有试验明显耗散能量，因此不能确定力与运动相对应
records-maybe-exchanged = 位移与力看来互换了，因此这些都不确定
records-sign-unsure = 文件以{ $direction }为正的把握只有 { $percent } %：{ $reasons }。请指明：若正确用 { $option }，否则用另一方向
records-negative-gas = 若如此计，气体将以 { $force } N 把活塞杆拉入，这不可能：要么方向有误（--positive），要么力传感器有零点偏移（--force-zero）
records-sign-of-rig = { $file }：单独看应以{ $own }为正（把握 { $percent } %）；该试验台最可靠的记录表明以{ $other }为正（{ $sure } %），故同样处理。若来自其他试验台，请用 --positive 指明
records-signs-disagree = { $file }：以{ $own }为正（把握 { $percent } %），而与之比较的记录以{ $other }为正（{ $sure } %）；若来自同一试验台，则其中之一有误：请用 --positive 指明
records-weak = 依据不足；请用 --positive rebound 或 --positive compression 说明
records-turned-round = 若将运动与力同时反号，{ $tests } 便与其他试验相符，按原样读取则不符：在相同速度下，复原与压缩之间的中间力在 { $test } 中为 { $own } N，在其他试验中为 { $usual } N。请检查这些文件的正方向是否不同，并更正导出或用 --exclude 排除
records-other-settings = 相同运动下 { $first } 的力是 { $second } 的 { $times } 倍：这是多个减振器，或同一减振器的多种设置（档位、电流），一个模型无法同时表示。请分开拟合（分文件夹，或用 --exclude）。{ $belong }
records-several-settings = 试验在 { $count } 种设置（{ $name }）下测量，而一个模型只能表示其中一种：{ $settings }。请用 dashpot fit --setting { $option } 将其作为随{ $name }变化的同一减振器拟合，或分别拟合每种设置并用 --exclude 排除其他设置；dashpot diagnose --group 可进行比较
records-not-one-damper = { $settings }。若要将其全部作为一个无设定的减振器拟合，请给出 --setting { $none }
records-setting-at = { $value }：{ $names }
records-setting-varies = 试验全程减振器阀的{ $setting }在 { $low } 与 { $high } 之间变化
records-setting-changes = { $change }。dashpot fit --setting { $option } 由此辨识阀的响应；单一设置的模型无法跟随它（--exclude）
records-setting-steps = 试验中减振器阀的{ $setting }在 { $low } 与 { $high } 之间阶跃 { $count } 次
records-setting-name = { $test } 的名称写明 { $named }，而其{ $setting }通道显示 { $shown }：以通道为准（名称与通道不符的试验数：{ $count }）。请核对；若以名称为准，请将其值写入 campaign.toml 的 settings
records-setting-typed = { $text } 不是设定值：请给出 -{ $largest } 到 { $largest } 之间的数值及其单位，例如 0.8 A、12 clicks 或 3 bar
records-setting-quantity = { $text } 不是{ $setting }的值；这些试验的设定量是{ $setting }
records-setting-quantities = 这些试验有多种设定量（{ $names }）；请只打开一种设定量的试验，再更正某个试验的设定值
records-settings = 按力归类，由软到硬：{ $settings }{ $open }
records-setting = { $number }) { $names }
records-setting-all = '{ $name }' 的全部（{ $count }）
records-setting-open = ；{ $names } 从力上无法判断
records-zero-off = 在相同速度下，{ $tests } 的力与其他试验相差 { $low } 至 { $high } N，两个方向相同：力传感器零点已移动，气体更热，或可调减振器处于其他设置。请在每次试验前调零；否则摩擦力与气体力会受影响
records-given = 已给定{ $direction }为正
records-against-given = 已给定{ $direction }为正，但数据说明相反：{ $reasons }

## What reading says of records. What a campaign does without.

records-left-out = 已舍去：{ $fault }
records-no-record = 已舍去，因其不是试验记录：{ $fault }
records-first-and-more = { $first }；另有 { $count } 个
records-more-left-out = 另有 { $count } 个文件和试验已舍去

## What reading says of records. Faults of files.

records-unknown-type = { $file }：不是试验记录；试验记录文件为 { $kinds }
records-not-read = { $file }：是{ $is }，不能读取；{ $instead }
records-empty-file = { $file }：为空（0 字节）；请重新导出
records-workbook = { $file }：不能作为工作簿读取（{ $cause }）；请重新保存为 .xlsx，或将工作表导出为 CSV
records-rpc = { $file }：不能作为 RPC III 时间历程读取（{ $cause }）
records-binary = { $file }：不能作为 { $kind } 读取（{ $cause }）
records-mat = { $file }：不能作为 MAT 文件读取（{ $cause }）；请用 save(..., '-v7') 重新保存
records-no-header = { $at }：未找到写明时间和其他通道的表头；第一行为“{ $found }”。{ $near }
records-best-line = 理解最多的是第 { $line } 行，其中有 { $known }；表头至少需要两列可以理解。
records-angle-alone = 列“{ $column }”是曲柄转角。若表格上方有一行注明转速（例如“Speed: 6 rpm”），即可由它得出时间。位移不由它计算：请同时导出位移，单独占一列。
records-taken-for = “{ $column }”（{ $channel }）
records-figures-alone = 该行含 { $count } 列数值而没有列名：请按列号一次性说明各列及其单位，例如 { $options }。
records-no-data = { $at }：有表头但没有数据行

## What reading says of records. What is wrong with what was asked for.

records-not-found = { $file }：没有这样的文件或文件夹；请检查路径
records-cannot-read = { $file }：无法读取（{ $cause }）
records-is-peak-table = { $file }：是峰值表，不是随时间的记录；用 dashpot import peaks { $file } -o damper.toml 可由它生成模型
records-not-regular = { $file }：不是普通文件，而是管道、设备或文件夹；请将其内容另存为文件并指定该文件
records-too-large = { $file }：大小为 { $size }，最多可读取 { $largest } 的文件；请按试验拆分，或减少通道、降低采样率后保存
records-too-costly = { $at }：解压后超出此大小文件的允许范围；请另存为 CSV 或按试验拆分
records-too-many-columns = { $at }，第 { $line } 行：有 { $found } 列，超过一条记录允许的 { $most } 列；请只保存需要的列
records-empty-folder = { $folder }：没有试验记录；试验文件夹中应有 { $kinds }
records-in-subfolders = { $folder }：本身没有试验记录；其子文件夹中有 { $count } 个文件：{ $names }。若它们是同一减振器的试验，请给出 --subfolders，将其作为一个试验系列读取；若各为不同的减振器，请给出其中一个，或用 dashpot diagnose --group folders 进行比较
records-kinds = { $others } 和 { $last }
records-no-paths = 未给出试验记录；请指定记录文件或试验文件夹
records-excludes-nothing = --exclude { $pattern } 与任何文件和试验都不符；第一个文件名为 { $first }
records-excludes-all = --exclude 之后没有剩下任何记录；全部 { $count } 个文件和试验都符合
records-profiles-disagree = { $first } 与 { $second } 规定的正方向不同；请统一，或给出 --positive
records-indispensable = 记录中不能缺少{ $channel }；请从 --ignore 中去掉
records-in-line = { $at }，第 { $line } 行：{ $cause }

## What reading says of records. Headings and units.

records-understood = { $header } 可识别的有：{ $understood }。其他列名可用 --column force="Load Cell 1" 给出
records-swapped = { $at }：列名“{ $first }”与“{ $second }”似乎互换了：{ $evidence }。请更正表头，或给出 --column { $of_first }="{ $second }" --column { $of_second }="{ $first }"（单位也互换时再加 --unit）；若无误，请用 --unit { $of_first }=... 坚持
records-wrong-unit = { $evidence }；这说明实为 { $likely } 却写成了 { $written }。请给出 --unit { $channel }={ $likely }，或用 --unit { $channel }={ $written } 坚持
records-files-unit = { $all } 个试验中有 { $count } 个与其他试验不符，且差异恰似单位之差：{ $tests }。{ $test } 在 { $velocity } mm/s 时为 ±{ $force } N，其他试验在 { $there } mm/s 时为 ±{ $usual } N；这说明实为 { $likely } 却写成了 { $written }。{ $either }{ $labels }请更正出错文件的列名；或将其放入单独的文件夹，运行一次 dashpot import-profile 文件夹 --unit { $channel }={ $first }，再同时给出两个文件夹。也可用 --exclude 排除它们；或用 --unit { $channel }={ $written } 坚持所有文件均以 { $written } 为单位
records-or-the-others = 若这些正确，则相反，出错的是其他试验：{ $others }。
records-or-labels = 若试验有多个设定，错误的标注也会造成同样的现象：请先检查标注。
records-labels-deviate = { $all } 个试验中有 { $count } 个的力与同一 { $name } 的其他试验矛盾，而与另一设定的试验一致：{ $groups }。{ $advice }
records-label-group = { $tests }（标注 { $stated }，力属于 { $fitting }）
records-label-group-or-unit = { $group }，或 { $likely } 写成了 { $written }
records-forces-unlike = 在相同速度下，{ $tests } 的力与其他试验的力相差超出减振器自身的变化（{ $test }：为其他试验的 { $factor } 倍）：请检查单位、增益和设定，或不使用这些试验
records-labels-check = 请检查这些试验的标注；更正值写入 campaign.toml 的 settings
records-labels-mirrored = 每个试验的力都相当于从另一端计数的 { $name }。请检查这些试验与其他试验从哪一端计数；更正值写入 campaign.toml 的 settings
records-missing-column = { $at }，第 { $line } 行：没有{ $missing }的列；现有各列为 { $found }。{ $near }请用 --column { $example }="列名" 指定{ $otherwise }{ $units }
records-units-too = 。单位也缺失：请按文件实际单位给出，例如 { $options }
records-or-crank-speed = ；或在表格上方的一行中注明曲柄转速，例如“Speed: 6 rpm”，列“{ $column }”即可给出时间
records-or-sample-rate = ；文件中没有时，请给出 --sample-rate 1000（每秒采样数）
records-several-columns = { $at }，第 { $line } 行：多个列都可能是 { $channel }：{ $names }；请用 --column { $channel }="{ $first }" 选定其一
records-no-such-column = { $at }，第 { $line } 行：没有作为{ $channel }的列“{ $wanted }”；现有各列为 { $found }。{ $near }
records-no-setting-column = 没有试验含有作为设置的列“{ $wanted }”：请检查表头，用 --column setting=HEADING 或在 campaign.toml 中给出
records-meant = 是否指“{ $near }”？
records-missing-unit = { $at }，第 { $line } 行：列“{ $column }”没有单位；请在列名中写成“{ $column } [{ $example }]”，或给出 --unit { $channel }={ $example }。{ $channel } 可用单位：{ $understood }
records-missing-units = { $at }，第 { $line } 行：{ $columns } 没有单位；请按文件实际单位给出，例如 { $options }{ $in_heading }。可用单位：{ $understood }
records-or-in-heading = ，或写入各列名，例如“力 [N]”
records-unknown-unit = { $at }，第 { $line } 行：列“{ $column }”的单位“{ $unit }”不适用于 { $channel }；可用单位为 { $understood }。列名有误时请给出 --unit { $channel }=...

## What reading says of records. What speaks for swapped headings.

records-time-stands = 读作时间的列在 { $percent } % 的行中倒退或停住，读作{ $other }的列则从不如此
records-spans = 位移将跨越 { $displacement } mm，力将跨越 { $force } N
records-force-smoother = { $spans }，而且力会是两者中较平滑的一个
records-derivative-of-force = 速度是读作力的列的导数（相关系数 { $with_force }），而不是读作位移的列的导数（{ $with_displacement }）
records-displacement-rougher = 读作位移的列比读作力的列粗糙 { $times } 倍，而且减振器会输出能量；{ $spans }

## What reading says of records. What speaks for another unit.

records-too-quick = { $record } 将以 { $frequency } Hz 运动 ±{ $amplitude } mm，历时 { $seconds } s
records-too-long = { $count } 个试验中最快的只达到 { $velocity } mm/s，最长的历时 { $hours } h，每 { $step } s 采样一次
records-too-stiff = 没有试验的运动超过 ±{ $amplitude } mm，而 { $velocity } mm/s 时的 { $force } N 意味着阻尼为 { $damping } N s/m
records-mixed-current = { $record }：减振器阀的电流将达到 { $current } A，而其他试验中最多为 { $others } A；这说明标题写 A 的列其实是 mA。请更正该文件的标题，或用 --exclude '{ $test }' 排除；若坚持，请给出 --unit current=A
records-too-much-current = 减振器阀的电流将达到 { $current } A
records-too-weak = { $count } 个试验中力最大的只有 ±{ $strongest } N，{ $test } 在 { $velocity } mm/s 时为 ±{ $force } N，阻尼为 { $damping } N s/m

## What reading says of records. What no damper has.

records-absurd = { $record }：显示{ $what }，悬架减振器不可能如此；{ $advice }
records-an-amplitude = 振幅 { $amplitude } m
records-a-velocity = 峰值速度 { $velocity } mm/s
records-a-force = 力 { $force } N
records-say-mm = 若文件单位为 mm，请说明：--unit displacement=mm；由速度积分时用 velocity=mm/s
records-check-motion-units = 请检查速度和时间的单位：--unit velocity=mm/s、--unit time=s
records-no-more-force = 力不超过 { $force } N
records-say-stronger = 若文件使用其他单位，请指明：--unit force=kN
records-unit-was-given = 单位已指明，因此应为其他单位，或列、系数、传感器有误：请检查；若表头已有单位，请去掉 --unit
records-say-n = 若文件单位为 N，请说明：--unit force=N

## What reading says of records. All tests of a campaign.

records-all-without-force = { $all } 个试验中有 { $count } 个没有力：在 { $record } 中减振器在运动，力却未超出其 { $noise } N 的噪声。请检查力传感器及其通道（--column force="列名"）
records-feeds-energy = 减振器会向试验台输出能量，说明有符号错误：{ $cause }
records-few-feed = { $count } 个试验中有 { $fewer } 个输出能量，其余 { $more } 个不输出：{ $names }。{ $apart }{ $also }
records-few-take = { $count } 个试验中有 { $fewer } 个耗散能量，其余 { $more } 个不耗散：{ $names }。{ $apart }{ $also }
records-apart = 这些文件的力或运动的正方向与其他文件不同。请分开载入，对输出能量者用 --flip force 或 --flip motion，或更正导出
records-all-feed = 在全部 { $count } 个环线清楚的试验中，力都顺着运动方向（相关系数 { $correlation }），因此力与运动的正方向相反；{ $culprit }{ $also }
records-exchanged = { $all } 个试验中有 { $count } 个的位移与力看来互换了：{ $names }。在 { $test } 中，按力读取的列像试验台运动那样呈正弦（谐波占 { $of_force } %），按位移读取的列则不是（{ $of_displacement } %）
records-exchanged-feed = { $exchanged }；这样读取时减振器会向试验台输出能量。请把 --column displacement="列标题" 与 --column force="列标题" 对调给出，单位也随之互换时再给出 --unit。若只有部分文件如此，请把它们放入单独的文件夹，在那里用 dashpot import-profile 注明，并同时给出两个文件夹
records-exchanged-doubt = { $exchanged }。若确实如此，以下内容均不成立：请把 --column displacement="列标题" 与 --column force="列标题" 对调给出，并去掉 --flip
records-or-late = 。也可能是{ $late }；此时请给出 { $option }
records-flip-motion = { $standstill }；因此位移和速度以压缩为正。请给出 --flip motion（或更正导出）
records-flip-force = { $standstill }；因此位移和速度以复原为正。请给出 --flip force（或更正导出）
records-flip-either = { $standstill }。若压缩力记为正请给出 --flip force，若压缩运动记为正请给出 --flip motion（或更正导出）

## What reading says of records. A motion to be imposed.

records-motion-beyond = { $at }，第 { $line } 行：{ $channel }为{ $value }，而运动不超过±{ $limit }；请检查该列的单位（可用 --unit 指明）
records-motion-gap = { $at }，第 { $line } 行：{ $channel }缺失或不是数字；运动按原样使用，请补全或截去
records-motion-time = { $at }，第 { $line } 行：时间没有递增：{ $from } s 之后是 { $to } s；运动需要递增的时间
records-short-motion = { $at }：只有一行；运动至少需要两行
records-several-motions = { $file }：含有多个试验，“{ $first }”和“{ $second }”；运动只能是一个，请拆分文件

## What reading says of records. Faults of tests.

records-too-few = { $at }：只有 { $samples } 个可用采样；一个试验至少需要 { $needed } 个，请重新测量
records-missing = { $at }，第 { $line } 行：{ $channel }通道缺失或不是数值，共 { $rows } 行中有 { $count } 行如此；太多，不能舍去。请修正导出{ $advice }
records-or-ignore = ，或用 --ignore { $channel } 舍去该通道
records-time-backwards = { $at }，第 { $line } 行：时间从 { $from } s 退回到 { $to } s。如果文件依次含有几个试验，请将区分它们的列命名为“test”，或拆分文件；否则请剪去多余的数据段
records-constant-time = { $at }：时间不前进，每行都是 { $time } s；请检查是否将正确的列读作时间
records-frozen = { $at }，第 { $first } 至 { $last } 行：{ $channel }通道在 { $value } { $unit } 停滞 { $seconds } s，而{ $moving }；{ $advice }
records-clipped = { $at }，首次在第 { $line } 行：{ $channel }通道有 { $percent } % 的采样在 { $value } { $unit } 处被削平，可信的数据太少；{ $advice }
records-no-motion = { $at }：减振器没有运动：{ $channel }通道只有噪声，在 { $range } { $unit } 以内。请重新测量；如果本来就应静止，请取出该试验
records-constant-force = { $at }：减振器运动时每行的力都是 { $value } N；请检查力传感器及其电缆，并重新测量
records-cell = { $at }，第 { $line } 行，“{ $column }”列：“{ $text }”不是数值{ $hint }
records-fields = { $at }，第 { $line } 行：有 { $found } 个字段，而表头有 { $expected } 个{ $hint }
records-contradiction = { $at }：位移与速度相互矛盾：{ $cause }

## What reading says of records. What moves while a channel is frozen, and what to do.

records-damper-moves = 减振器在运动
records-velocity-moves = 速度表明它在运动
records-force-changes = 力在变化
records-displacement-changes = 位移在变化
records-check-cell = 请检查力传感器及其电缆，并剪去这些行或重新测量
records-read-displacement-only = 请剪去这些行，或只读取位移：--ignore velocity
records-read-velocity-only = 请剪去这些行，或只读取速度：--ignore displacement
records-cut-or-measure = 请剪去这些行或重新测量

## What reading says of records. What to do about a clipped channel.

records-no-other-motion = 没有其他运动通道；请用更大的量程重新测量
records-larger-range = 请用量程更大的力传感器或放大器重新测量

## What reading says of records. Why a cell or a row may be wrong.

records-without-separators = ；请不要使用千位分隔符
records-format-as-numbers = ；请将单元格设为数值格式
records-quote-decimal-commas = ；使用小数逗号时，单元格须加引号，或以分号或制表符分隔各列

## What reading says of records. How displacement and velocity contradict each other.

records-velocity-late = “{ $column }”{ $side }位移的导数 { $lag } ms，如同经过滤波；未使用该列，速度由位移求得
records-behind = 滞后于
records-ahead = 超前于
records-other-motion = 速度的积分只能解释 { $percent } % 的位移；它们不属于同一运动。请检查读取的列是否正确（--column velocity="heading"），{ $advice }
records-opposite-signs = 二者符号相反（速度为位移导数的 { $gain } 倍）。请在导出时反转其中之一，{ $advice }
records-unit-slip = 速度为位移导数的 { $gain } 倍，单位有误。最可能的是{ $likely }{ $others }
records-unit-candidate = { $channel }通道的单位为 { $likely }，而读取为 { $read }，由此试验为 { $frequency } Hz、{ $amplitude } mm、{ $velocity } mm/s：请给出 { $option }
records-otherwise = 。否则{ $others }
records-or-else = {"；或"}
records-other-scale = 速度为位移导数的 { $gain } 倍。请检查二者的单位和标定、时间单位，以及采样对该运动是否足够快，{ $advice }
records-read-one-only = 或只读取其中之一：--ignore velocity（或 --ignore displacement）

## What reading says of records. Channels.

records-channel-time = 时间
records-channel-displacement = 位移
records-channel-velocity = 速度
records-channel-force = 力
records-channel-side-force = 侧向力
records-channel-temperature = 温度
records-channel-current = 电流
records-channel-setting = 设置

## What reading says of records. Files in formats that are not read, and what to do.

records-famos = { " " }imc FAMOS 文件
records-old-workbook = { " " }Excel 97 至 2003 的工作簿（.xls）或同时期的文档
records-open-document = { " " }OpenDocument 文件
records-diadem-heading = { " " }DIAdem 数据集的文件头，其数值在其他文件中
records-diadem = { " " }DIAdem 数据集
records-hdf5 = { " " }HDF5 文件
records-database = 数据库
records-zip = 压缩包（zip）
records-gzip = 压缩文件（gzip）
records-pdf = { " " }PDF 文件
records-xml = { " " }XML 文件
records-catman = { " " }catman 的二进制文件
records-export-from-imc = 请在 imc FAMOS 或 imc STUDIO 中导出为 CSV、MDF 4 或 TDMS
records-save-as-xlsx = 请保存为 .xlsx
records-save-as-tdms = 请在 DIAdem 中保存为 TDMS
records-save-channels = 请将其通道保存为 CSV 或 MAT 文件
records-export-as-csv = 请将试验导出为 CSV
records-unpack-folder = 请解压并指定其文件夹
records-unpack = 请解压
records-export-from-catman = 请在 catman 中导出为 ASCII、MDF 4 或 MAT

# What a fit says.

## What a fit says. Lists.

identification-comma = 、
identification-semicolon = ；
identification-that = ，

## What a fit says. Which tests a number was identified from.

identification-share-of = { $tests } { $percent } %
identification-no-test = 没有试验能显示

## What a fit says. The inventory.

identification-carries = { $effect }：均方根 { $force } N，占力的 { $share }；概率 { $probability }
identification-carries-in-form = { $effect }（{ $form }）：均方根 { $force } N，占力的 { $share }；概率 { $probability }

## What a fit says. What the data does not determine.

identification-not-identified = { $name } 无法由这些数据辨识（{ $why }）；其元件未启用
identification-needs-side-forces = 需要在两种或更多侧向力下的慢速试验，并有侧向力通道
identification-taken-up = 自由的 FV 曲线会吸收 v² 项
identification-held = { $name } 无法由这些数据辨识；固定为 { $value }
identification-at-bound = { $name } 到达其范围边界 { $value }：数据要求的是该元件做不到的
identification-rare-value = { $name } 为 { $value }，超出此力级减振器和试验台所示的范围（{ $low } 至 { $high }）：它可能在弥补模型所缺的部分
identification-rare-assumed = { $name } 假定为 { $value }，超出此力级减振器和试验台所示的范围（{ $low } 至 { $high }）：它可能在弥补模型所缺的部分

## What a fit says. What was known of the damper beside its records.

identification-expected = 根据减振器的尺寸（{ $facts }），{ $name } 预期为 { $value } { $unit }（95 %：{ $low } 至 { $high }）
identification-contradicts = { $name } 与减振器的尺寸矛盾：{ $value } { $unit } 是由 { $facts } 得出的 { $expected } { $unit } 的 { $ratio } 倍

## What a fit says. What the campaign cannot show.

identification-one-rate = 所有试验的换向快慢几乎相同，力通道滞后与串联路径偏软看起来一样：认为该通道没有滞后；以三分之一频率做同一行程的试验可将二者区分
identification-one-test = 在单个试验中，力通道滞后与串联路径偏软看起来一样：认为该通道没有滞后；以三分之一频率做同一行程的试验可将二者区分
identification-roads = { $roads } 个没有循环的长试验各以 { $stretches } 段、每段 { $seconds } s 计算，所选各段经过其全部位移和速度；全记录误差计入每个采样点
identification-selected = 本次测量有 { $all } 个试验，多于搜索所能使用的数量：以其中 { $selected } 个代表全部，涵盖各种振幅、速度、平均位置、温度和侧向力，并分布于整个过程。全记录误差计入所有试验；若要自行选择，请使用 --exclude 或较小的文件夹
identification-no-slow-test = 没有含完整循环的慢速试验（峰值低于 { $velocity } mm/s）：摩擦取自较快试验的慢速部分
identification-no-slow-test-no-friction = 没有含完整循环的慢速试验（峰值低于 { $velocity } mm/s）：这种试验最能显示摩擦，而模型没有摩擦
identification-one-amplitude = 所有试验的振幅几乎相同：弹簧和串联刚度仅由频率确定
identification-one-amplitude-of-spring = 所有试验的振幅几乎相同：弹簧仅由频率确定
identification-one-amplitude-of-series = 所有试验的振幅几乎相同：串联刚度仅由频率确定
identification-one-fast-amplitude = 所有快于 { $velocity } mm/s 的试验振幅几乎相同：串联刚度仅由频率确定
identification-zero-moves = 模型在各试验中剩下各不相同的恒定力，从 { $low } 到 { $high } N：力通道的零点在试验之间移动，或气体升温。请在每次试验前调零，或用同一时钟连续测量以便找出漂移；摩擦力和气体力不可信

## What a fit says. What the measurement is off by.

identification-found-early = 力通道超前 { $value } ms（95 %：{ $low } 至 { $high }）
identification-found-delay = 力通道比运动滞后 { $value } ms（95 %：{ $low } 至 { $high }）
identification-found-mass = 力传感器带动自身的质量 { $value } kg（95 %：{ $low } 至 { $high }）
identification-found-gain-drift = 力通道的增益每分钟漂移 { $value } %（95 %：{ $low } 至 { $high }）
identification-found-drift = 力通道的零点每分钟漂移 { $value } N（95 %：{ $low } 至 { $high }）
identification-or-warm-gas = 并非所有试验都记录了温度：气体在测试过程中升温同样会使静止力下降。温度可以区分二者
identification-gas-at = gas_force 为 { $temperature } °C（实测温度范围的中点）时的值；按 gas_warming_rate 随温度增大
identification-doubtful-error = { $effect }的概率仅为 { $probability }：拟合未尝试的减振器效应（例如油中的空气）可能与之相似。dashpot diagnose 会尝试所有效应
identification-taken-out-here = { $finding }：此处已去除，不在模型中；validate 和 diagnose 也会从这些记录中去除{ $option }
identification-give-option = ；对该试验台的其他记录请给出 { $option }，或写入其 campaign.toml
identification-taken-out-as-the-fit-did = 已按模型辨识时的做法从记录中去除：{ $findings }
identification-found-in-its-own = 模型辨识在其自身的记录中发现：{ $findings }；这里是别的记录，未从中去除任何成分{ $option }
identification-if-the-same-rig = ：如果由同一试验台测得，请给出 { $options }

## What a fit says. What a model file holds that does nothing.

identification-idle = 模型文件给出了 { $names }，但元件 { $element } 已关闭，因此这些值不起作用；如需使用，请将其加入 elements

## What a fit says. Numbers that a model file does not give, and numbers that are not those of its fit.

identification-family-worse = 该族模型的误差是仅对此设定单独辨识的 { $ratio } 倍：各设定共用的某个参数在此可能不同，其中一些试验可能标注了另一设定，或这些试验太少而无法显示差异
identification-alone-worse = 单独拟合此设置的偏差是整族的 { $ratio } 倍，即其搜索停在较差的结构：与它之比没有意义
identification-on-defaults = 元件 { $element } 已启用，但模型文件未给出 { $names }：采用 docs/parameters.md 中的默认值
identification-edited = { $names }：超出辨识在模型文件中给出的 95 % 区间，因此此后被修改过；辨识对其所知的内容不再列出

## What a fit says. How far a fit is.

identification-preparing = 正在准备试验记录
identification-plain-curve = 普通 FV 曲线
identification-first-fit = 由多个起点进行首次拟合
identification-choosing-structure = 比较摩擦、弹簧、串联路径和测量误差
identification-refining = 整体精修
identification-piecewise = 分段线性曲线
identification-with-lag = 带滞后的多项式
identification-done = 完成

## What a fit says. A damper over a setting.

identification-family-each = 逐个设置
identification-family-joint = 所有设置一起：哪些共有，哪些随设置变化
identification-family-left-out = 由其他设置预测每个设置
identification-family-actuator = 由设置变化的试验得到阀的响应
identification-changing-setting = 设置变化的试验
identification-no-actuator = { $count } 个{ $setting }变化的试验未显示执行器：力在采样和噪声范围内跟随指令
identification-actuator-open = 记录不能确定 { $names }：取阀通常的数值
identification-actuator-vague = 试验使 { $names } 的不确定度超过 { $width } ms。请在快速运动中增加{ $setting }在多对设置之间上升和下降的阶跃
identification-actuator-two-settings = 阀的时间假定力在 { $low } 与 { $high } 之间随{ $setting }线性变化：若力为曲线，误差会超出其区间。请测量两者之间的一个设置
identification-family-selected = 本次测量有 { $all } 个试验，多于搜索所能使用的数量：以其中 { $selected } 个代表全部，每个设置最多 { $most } 个，设置变化的 { $changing } 个，涵盖各种振幅、速度、平均位置、温度和侧向力。全记录误差计入所有试验；若要自行选择，请使用 --exclude 或较小的文件夹
identification-no-interval-between = { $names }：位于两个设置之间，此处无区间；拟合三个或更多设置才能显示插值误差
identification-label-suspect = { $test } 标明 { $name } { $stated }，但其力属于 { $fitting }：在所标设定下模型的误差为后者的 { $ratio } 倍。请检查该标注；更正值写入 campaign.toml 的 settings
identification-label-stray = { $test } 标明 { $name } { $stated }，但其力属于 { $fitting }，而不属于相邻设定。请检查该标注；更正值写入 campaign.toml 的 settings
identification-setting-doubt = { $test } 的力约为 { $fitting } 的力，而非 { $stated } 的力：模型在前者偏差 { $fitting_error } N，在后者偏差 { $stated_error } N。请检查该试验的设定值及其单位
identification-labels-exchanged = 阻尼力在 { $name } 上并非单调变化；若将 { $one } 与 { $other } 互换则会单调。请检查这些试验的标注；若阻尼器确实如此，则按测量建模
identification-labels-opposed = 在 { $name } 上，{ $direction }阻尼力在 { $rising } mm/s 附近上升，在 { $falling } mm/s 附近下降。某些试验的 { $name } 可能从另一端计数：请检查其标注；若阻尼器确实如此，则按测量建模
identification-family-stores = 改变 { $setting } 可能对宿主做功，因为它改变储存的能量或静止时的力：{ $sources }
identification-energy-of-number = { $name } { $range }
identification-energy-at-rest = FV 曲线在零速度时的力，{ $range }
identification-energy-of-lag = { $element } 的滞后力
identification-energy-range = 从 { $low_at } 时的 { $low } 到 { $high_at } 时的 { $high }
identification-family-no-setting = 没有试验说明 { $name }。请写入所有试验的名称（800mA、12clicks、150psi），给出其列（--column setting=HEADING），给出无单位电流列的单位（--unit current=A），或在旁边的 campaign.toml 中写入 setting 和 [settings]{ $unread }
identification-family-unread = ；{ $note }
identification-family-other-setting = 没有试验说明 { $name }；试验的设置名为 { $known }：请用该名称给出 --setting
identification-family-without = 以下试验未说明 { $name }：{ $tests }（共 { $count } 个）。请用 --exclude 排除，用 --column setting=HEADING 指明其列，或在 campaign.toml 的 settings 中给出{ $unread }
identification-family-one = 所有恒定 { $name } 的试验都是 { $value }：随其变化的模型至少需要两个值。请不带 --setting 拟合，或检查该列的单位
identification-family-only-changing = 全部 { $count } 个试验中 { $name } 都在变化：随其变化的减振器须用两个或更多恒定设置下的试验拟合，变化的试验用于辨识其阀
identification-family-too-many = 试验有 { $count } 个 { $name } 值，而模型最多容纳 { $most } 个：请用 --exclude 或 --hold-out 排除一些，或在 campaign.toml 的 [settings] 中写明设定值
identification-family-at = { $name } = { $value } 时：{ $why }
identification-family-kernel = 这些设置不能构成模型：{ $parameter } { $why }
identification-family-not-finite = 无法为所有设置一起计算出有限的力；请逐个拟合以找出有问题的试验

## What a fit says. Why there is no fit.

identification-no-tests = 没有可拟合的试验：请给出至少含一个记录的文件夹或文件
identification-unknown-element = 没有名为 { $name } 的元件；元件有 { $known }
identification-not-fitted = fit 不辨识 { $name }：由 dashpot diagnose 找到后加入已拟合的模型，或手工加入；fit 可用 { $known }
identification-other-family = { $name } 是独立的模型，不接受其他元件；请使用 --model lag
identification-one-sided = 试验从未向{ $direction }方向运动：力—速度曲线需要两个方向
identification-not-finite = 试验 { $test } 无法算出有限的力；请查看其通道（位移有跳变？）

# What a diagnosis says.

## What a diagnosis says. How far a diagnosis is.

diagnosis-preparing = 正在准备试验记录
diagnosis-fitting-reference = 将模型拟合到参考
diagnosis-refitting = 对现有模型重新拟合
diagnosis-each-effect = 逐个加入效应并整体重新拟合
diagnosis-weighing = 在其他效应存在时权衡每个名称
diagnosis-what-is-left = 查看剩余部分
diagnosis-done = 完成

## What a diagnosis says. Why there is no diagnosis.

diagnosis-no-tests = 没有可诊断的试验：请给出至少含一个记录的文件夹或文件，且不要全部排除
diagnosis-unknown-name = 没有名为 { $name } 的效应；效应有 { $known }
diagnosis-nothing-to-compare = 参考试验中没有与本试验相同的项目（振幅、频率、平均位移和侧向力在 5 % 以内相同）：请对两支减振器做相同的试验矩阵{ $turned }
diagnosis-besides = ；{ $said }
diagnosis-opposite = 本试验按{ $own }为正读入，参考试验按{ $good }为正读入；若二者来自同一台试验机，请都用 --positive rebound 或都用 --positive compression 读入
diagnosis-identical = 参考试验中含有逐值相同的记录：{ $tests }；这些记录不可能有任何变化，请检查参考文件夹是否正确
diagnosis-not-finite = 模型对这些记录给不出有限的力：请运行 dashpot validate 查看位置

## What a diagnosis says. Lists.

diagnosis-comma = 、
diagnosis-and = 与

## What a diagnosis says. The answer.

diagnosis-times = 噪声和曲线形式所留误差的 { $times } 倍
diagnosis-name-and-sure = { $effect }（把握 { $percent }{ $instead }）
diagnosis-instead-of = ，取代 { $effect }
diagnosis-has-effect = 该减振器显示 { $names }；{ $residual }，{ $rest }{ $also }
diagnosis-residual-falls = 残差由噪声与曲线误差的 { $before } 倍降至 { $after } 倍
diagnosis-residual-stays = 残差没有下降（以噪声与曲线误差为单位：之前 { $before } 倍，之后 { $after } 倍）
diagnosis-leaves-nothing = 没有未解释的部分
diagnosis-leaves-a-part = 仍有一部分未得到解释
diagnosis-new-effect = 该减振器上新出现：{ $names }；{ $residual }，{ $rest }{ $also }
diagnosis-also-changed = ；另有变化：{ $changes }
diagnosis-at-all-settings = 该减振器在每个设置下都表现出 { $effect }（把握 { $sure }{ $instead }）
diagnosis-at-some-settings = { $effect }（把握 { $sure }{ $instead }）在 { $names } 处为模型所缺；在其他设置下未被指明
diagnosis-only-together = 没有任何单个设置需要 { $effects }；单个设置提供的信息少于全部设置，因此由对全部设置的拟合（dashpot fit --setting）决定模型是否保留该效应
diagnosis-at-no-setting = 在任何设置下，模型都不缺少这些记录能够指明的效应
diagnosis-changed-at-all-settings = { $name } 在每个设置下都有变化（把握 { $sure }）
diagnosis-changed-at-some-settings = { $name } 在 { $names } 处有变化（把握 { $sure }）；在其他设置下未见其变化
diagnosis-changed-at-no-setting = 在任何设置下，都没有这些记录能够指明的变化
diagnosis-settings-not-in-model = 模型未在 { $names } 处测量：该处数值为插值，诊断先将其拟合到这些记录，因此不评判插值；请用 dashpot validate 检查
diagnosis-no-name-at-all-settings = 在每个设置下都缺少某种尚未命名的效应
diagnosis-no-name-at-some-settings = 在 { $names } 处缺少某种尚未命名的效应
diagnosis-needless = 所考察的效应均无缺失；这些记录不需要 { $effects }
diagnosis-not-explained = { $percent } 的偏差未被所确定的效应解释：是它的另一种形式，或是别的原因
diagnosis-immaterial = 改进后的模型还含有 { $effects }，未作为结论：没有任何试验中的力超过噪声和所测力的 0.5 %
diagnosis-test-and-times = { $test }（{ $times } 倍）
diagnosis-detection-limit = 模型与平均循环的偏差为 { $residual } N（有效值），其噪声为 { $noise } N：差值计入 FV 曲线的形状误差，同等大小的效应无法与之区分
diagnosis-still-missed = 太少或太小而无法确定，但以下试验的误差明显：{ $tests }
diagnosis-nothing-missing = 没有这些记录能够显示的已知效应缺失：模型偏差为{ $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-none-of-asked = 所询问的效应（{ $effects }）中，没有这些记录能够显示的缺失：模型偏差为{ $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-unchanged = 没有这些记录能够显示的变化：参考模型偏差为{ $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-unchanged-of-asked = 就这些记录所能显示，没有数值变化，所询问的效应（{ $effects }）也无新增：参考模型偏差为{ $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-without-cause = ；均方误差的 { $percent } 没有已知原因
diagnosis-likeliest = ；模型以外最可能的效应是{ $effect }（把握 { $percent }）
diagnosis-warmer = 试验温度比参考{ $sense }，最多 { $kelvin } K（{ $test }：平均 { $here } 与 { $there } °C）：气体力每开尔文增大 0.34 %，热油阻尼较小，因此部分差异可能来自温度，尤其是力零点漂移；请比较温度相近的试验
diagnosis-warmer-sense = 高
diagnosis-colder-sense = 低
diagnosis-changed = { $numbers }{ $more }
diagnosis-nothing-else = ；其余没有变化
diagnosis-nothing-else-large = ；其余变化均不超过力的 0.5 %
diagnosis-more-may-have-changed = ；可能还有其他变化，因为模型偏差仍为{ $times }
diagnosis-changed-both = 复原与压缩阻尼力 { $percent } %（{ $velocity } mm/s 处 { $reference } → { $value } N）
diagnosis-changed-rebound = 各速度下复原力 { $percent } %（{ $velocity } mm/s 处 { $reference } → { $value } N）
diagnosis-changed-compression = 各速度下压缩力 { $percent } %（{ $velocity } mm/s 处 { $reference } → { $value } N）
diagnosis-changed-rebound-low = 低速复原力 { $percent } %（{ $velocity } mm/s 处 { $reference } → { $value } N）
diagnosis-changed-compression-low = 低速压缩力 { $percent } %（{ $velocity } mm/s 处 { $reference } → { $value } N）
diagnosis-changed-rebound-high = 高速复原力 { $percent } %（{ $velocity } mm/s 处 { $reference } → { $value } N）
diagnosis-changed-compression-high = 高速压缩力 { $percent } %（{ $velocity } mm/s 处 { $reference } → { $value } N）
diagnosis-other-number = { $name } { $reference } → { $value }
diagnosis-uncertain-change = { $change }（不确定：95 % 区间 { $low } 至 { $high } { $unit } 包含参考值）
diagnosis-more-numbers = ，另有 { $count } 处
diagnosis-cannot-show = ；它们无法显示 { $effects }
diagnosis-not-confirmed = ；没有留出试验来证实
diagnosis-cannot-tell = 缺少某种效应：模型偏差为{ $times }，{ $why }
diagnosis-too-few-tests = { $effect } 是最可能的名称，但支持它的试验太少，不足以确定
diagnosis-not-apart = 这些记录无法区分 { $effects }
diagnosis-unknown-effect = 模型偏差为{ $times }，已知效应都不足以解释{ $nearest }
diagnosis-looks-like = ；看起来像{ $what }
diagnosis-nearest = ；最接近的 { $effect } 可解释 { $percent }
diagnosis-explains = 可解释 { $percent } 的偏差

## What a diagnosis says. What a disagreement without a name looks like.

diagnosis-like-guides = 随力增大的摩擦，如倾斜的横梁或吊环在导向处产生的那样
diagnosis-like-load-cell = 与速度无关的力回线，如有滞回的力传感器所画出的那样
diagnosis-like-resonance = 力传递路径中的共振，如机架或软管中油液的共振

## What a diagnosis says. Regions.

diagnosis-region = { $direction }，{ $slow }–{ $fast } mm/s{ $phase }，{ $place }：{ $missing }（均方根 { $rms } N，噪声 { $noise } N）
diagnosis-rebound = 复原
diagnosis-compression = 压缩
diagnosis-speeding-up = （加速时）
diagnosis-slowing-down = （减速时）
diagnosis-in-all-tests = 到达该处的全部试验中
diagnosis-in-test = 试验 { $test } 中
diagnosis-more-tensile = 实测力比计算力偏拉 { $mean } ± { $error } N
diagnosis-more-compressive = 实测力比计算力偏压 { $mean } ± { $error } N
diagnosis-off-both-ways = 实测力时高时低于计算力

## What a diagnosis says. Tests that would tell more.

diagnosis-run-sine = 进行 { $amplitude } { $unit }、{ $frequency } Hz 的正弦试验{ $about }{ $under }：{ $a } 与 { $b } 在此相差均方根 { $difference } N
diagnosis-about-mean = ，平均位置 { $mean } { $unit }（按文件的计法）
diagnosis-under-side-force = ，侧向力 { $force } N
diagnosis-shows-best = 最能显示 { $effect } 的试验：{ $remedy }
diagnosis-no-trace = 以通常的强度，它在这些试验中不会留下痕迹：{ $remedy }
diagnosis-sum-alone = 缸筒随压力膨胀，与油柱的压缩成比例：台架只显示两者之和，由油液可压缩性（oil_compressibility）代表

## What a diagnosis says. The test that shows an effect best.

diagnosis-show-more = 更多的振幅和频率
diagnosis-show-slow = { $slow } 至 { $fast } { $speed_unit } 的慢速三角波，两种行程，两种温度
diagnosis-show-spring = 慢速走完全行程，并以 1 Hz 走一次，取两个平均位置
diagnosis-show-gas-warming = 在行程中点静止时的力：冷态与剧烈工作后各测一次，并记录温度
diagnosis-show-mount = { $low } 至 { $high } Hz、{ $small } 至 { $large } { $unit } 的正弦
diagnosis-show-zero = 读取静止时的力，分别在装上和拆下减振器时
diagnosis-show-presliding = { $low } 和 { $high } Hz 下 { $small } 至 { $large } { $unit } 的行程：回线相同即为佐证
diagnosis-show-side-force = 同一正弦，侧向力 0、{ $half } 和 { $full } N
diagnosis-show-oil = 同一峰值速度，多种行程和频率，两个平均位置
diagnosis-show-aeration = 静置一夜后和运行 200 个周期后各做一次同样的试验
diagnosis-show-cavitation = 同一峰值速度，多种行程，提高气体压力
diagnosis-show-fade = 冷态和热态重复同一参考试验，顺序打乱，并记录温度
diagnosis-show-position = 在五个或更多平均位置做 { $small } 至 { $large } { $unit } 的正弦
diagnosis-show-bump-stop = 朝 { $lowest } { $unit }（按文件的计法）慢速压入限位，再以两种速度压入
diagnosis-show-rebound-stop = 朝 { $highest } { $unit }（按文件的计法）慢速拉入限位，再以两种速度拉入
diagnosis-show-free-play = 小行程试验，分别有和没有使力不过零的预载
diagnosis-show-frequency = 同一峰值速度，从 { $low } 至 { $high } Hz 的五个频率
diagnosis-show-valve = 缓慢升降速度，通过特性曲线拐点
diagnosis-show-mass = 不装减振器运行试验台
diagnosis-show-delay = 用弹簧代替减振器运行：其回线必须闭合
diagnosis-show-drift = 在开始、中间和结束时重复参考试验
diagnosis-semicolon = ；
diagnosis-beyond = { $test }（超出这些试验达到的范围：{ $demands }）
diagnosis-beyond-amplitude = ±{ $value } { $unit }，已达到 ±{ $reached } { $unit }
diagnosis-beyond-speed = { $value } { $unit }，已达到 { $reached } { $unit }
diagnosis-beyond-frequency = { $value } { $unit }，已达到 { $reached } { $unit }
diagnosis-beyond-side-force = 侧向力 { $value } { $unit }，已达到 { $reached } { $unit }

## What a diagnosis says. Why records cannot show an effect.

diagnosis-needs-series = 它属于串联路径：模型首先需要串联柔度（series_compliance）
diagnosis-series-added = 它需要 series_compliance，而该元件刚由本次诊断加入：请对改进后的模型再次运行 dashpot diagnose
diagnosis-needs-fixed-curve = 自由的 FV 曲线会吸收 v² 项：需要由规格固定该曲线
diagnosis-needs-side-force = 侧向力没有变化：在两种或更多侧向力下做同一正弦，并记录该通道
diagnosis-needs-temperature = 没有变化的温度通道，记录的时钟也显示没有升温：请记录油温或筒温，或在冷态和剧烈工作后重复同一试验
diagnosis-needs-measured-temperature = 没有变化的温度通道：请在所有试验中记录油温或筒温
diagnosis-needs-places = 所有试验都以相同速度经过相同位置：在五个或更多平均位置做小幅正弦，或以多种行程做同一峰值速度
diagnosis-only-within-compression = 压缩方向仅到 { $lowest } { $unit }（按文件的计法）：慢速压缩并超出这些试验达到的范围，才能看到那里的限位
diagnosis-only-within-extension = 拉伸方向仅到 { $highest } { $unit }（按文件的计法）：慢速拉伸并超出这些试验达到的范围，才能看到那里的限位
diagnosis-needs-frequencies = 各试验频率几乎相同：在从 { $low } 至 { $high } Hz 的五个频率下做同一峰值速度
diagnosis-needs-zero = 力传感器零点误差与气体力是同一常数：请在试验前后拆下减振器读取力传感器
diagnosis-needs-one-clock = 每条记录都重新计时：整个试验过程使用同一时钟，并重复参考试验

## What a diagnosis says. What is said of the improved model.

diagnosis-diagnosis = 诊断：{ $answer }
diagnosis-added = { $effect }（把握 { $percent }）已加入该模型
diagnosis-of-the-rig = { $effect }（把握 { $percent }）来自试验台：仅在比较中修正，不在该模型的减振器中
diagnosis-or-warm-gas = 并非所有记录中温度都有变化：气体在测试过程中升温会使静止力下降，与零点漂移无法区分。请记录油温或筒温
diagnosis-all-fitted-tests = 全部参与拟合的试验

## What a diagnosis says. How the comparison was made.

diagnosis-without-reference = 没有参考试验时，名称可能代表模型形式中固有的误差；若在同一试验台上测过完好的减振器，可用 --reference 查明变化
diagnosis-against-reference = 与参考试验对比：模型在参考的相同试验中留下的残差已扣除{ $nearest }{ $aside }
diagnosis-by-nearest-motion = ；没有相同运动的对应试验者，按最相近试验的形式误差比较：{ $tests }
diagnosis-without-counterpart = ；参考试验中没有类似的运动，因此以下试验含有模型的形式误差：{ $tests }

# What is said of the dimensions of a damper.

## What is said of the dimensions of a damper. Why a quantity cannot be told.

dimensions-no-gas-force = 模型没有气体力；慢速试验可显示它
dimensions-gas-force-open = 记录不能确定气体力；慢速试验可显示它
dimensions-gas-on-rod = 气体作用在活塞杆面积上
dimensions-no-gas-spring = 模型没有气体弹簧；覆盖全行程的慢速试验可显示它
dimensions-gas-spring-open = 记录不能确定气体刚度；覆盖全行程的慢速试验可显示它
dimensions-volume-from = 由气体的压力和刚度得出
dimensions-column-from = 油柱刚度取决于腔室的面积和长度
dimensions-no-column = 模型没有由记录确定的油柱或串联弹簧
dimensions-eyes-too-soft = 在其公差范围内，给定的吊环比模型中吊环与油的整体更软
dimensions-no-modulus = 有效模量未知
dimensions-tube-expands = 缸筒随油液膨胀
dimensions-stroke-from = 空气让出的行程取决于其压力和腔室长度
dimensions-air-from = 它是油液模量的缺失部分，或元素 aeration 的行程
dimensions-passage-from = 通道面积由 FV 表和活塞面积得出
dimensions-few-slow-points = 此行程拐点以下的 FV 表点少于两个
dimensions-no-knee = 此行程的 FV 表没有拐点：没有阀门开启
dimensions-bleed-passes-all = 节流孔通过全部流量

## What is said of the dimensions of a damper. What else is to know of a quantity.

dimensions-by-compression = 根据压缩时的油柱
dimensions-less-the-eyes = 串联弹簧减去吊环
dimensions-column-bound = 仅为界限：油柱还包含吊环；eye_stiffness_n_mm 或模型中的串联弹簧可将其分开
dimensions-column-less-the-eyes = 油柱扣除吊环柔度，因为模型没有串联弹簧
dimensions-a-bound = 仅为界限：串联弹簧包含吊环和油液；eye_stiffness_n_mm 或模型中的油柱可将其分开
dimensions-with-air = 含其中的空气
dimensions-no-orifice = 除泄漏外未见节流孔
dimensions-of-all-passages = 为所有层流通道之和，间隙泄漏最多为此值
dimensions-spring-is-more-than-gas = 若并联弹簧即为气体；图纸所注的 { $drawn } cm³ 约占该弹簧刚度的 { $percent } %，其余由另一弹簧产生
dimensions-if-spring-is-gas = 若并联弹簧即为气体
dimensions-no-leak = 除节流孔外未见泄漏
dimensions-opening-at = 表中最大力时的开口
dimensions-in-doubt = 按图纸使用 { $entries }，下述矛盾使其存疑
dimensions-had-prior = 拟合时对此使用了尺寸先验
dimensions-doubtful-effect = 仅当减振器具有{ $effect }时成立，其在拟合中的概率为 { $probability }
dimensions-comma = 、
dimensions-semicolon = ；

## What is said of the dimensions of a damper. What contradicts.

dimensions-contradicts-one = 模型的{ $noun }为 { $model }，是由 { $facts } 得出的 { $dimensions } 的 { $ratio } 倍。{ $cause }
dimensions-contradicts-several = 模型的{ $noun }为 { $model }，是 { $facts } 给出的 { $dimensions } 的 { $ratio } 倍。{ $cause }
dimensions-contradicts-zero = 模型的{ $noun }为 { $model }，与 { $facts } 的 { $dimensions } 矛盾。{ $cause }
dimensions-explained-by = 能解释它的图纸单项最小改动是 { $entry } = { $value }。
dimensions-no-cause = 图纸中没有任何单独一项能解释它。
dimensions-pressure-on-rod = { $pressure } bar 作用于 { $diameter } mm 的活塞杆

## Words in sentences. Words of records.

word-rebound = 复原
word-compression = 压缩
word-time = 时间
word-force = 力
word-displacement-or-velocity = 位移或速度
word-an-incomplete-cycle-or-run-down = 不完整的循环或停机过程
word-rest = 静止
word-nothing = 无
word-current = 电流
word-clicks = 档位
word-voltage = 电压
word-pressure = 压力

## Words in sentences. Kinds of tests.

word-slow-tests = 慢速试验
word-small-strokes = 小行程
word-large-strokes = 大行程

## Words in sentences. Paths and families of effects.

word-gas-and-springs = 气体与弹簧
word-constant-force = 恒力
word-spring = 弹簧
word-gas-temperature = 气体温度
word-friction = 摩擦
word-dry-friction = 干摩擦
word-viscous-friction = 粘性摩擦
word-friction-under-load = 受载摩擦
word-series = 串联
word-mount = 安装支座
word-hydraulic = 液压
word-oil-column = 油柱
word-void = 空穴
word-oil-temperature = 油温
word-valves = 阀
word-stop = 限位
word-rig = 试验台
word-mass = 质量
word-timing = 时序
word-load-cell = 力传感器

## Words in sentences. Forms of effects.

word-changed = 已变化
word-full = 完整
word-simplified = 简化
word-slips-from-the-first = 一开始即滑移
word-bends-before-it-slips = 先变形后滑移
word-relaxes = 松弛
word-friction-in-the-rubber = 橡胶内摩擦
word-relaxes-over-decades-and-meets-a-stop = 跨数个时间量级松弛并碰到限位
word-friction-in-the-rubber-and-a-stop = 橡胶内摩擦，并有限位
word-opens-under-a-load = 在载荷下张开
word-all-of-the-force-goes-through-it = 全部力经过它
word-friction-and-gas-act-behind-it = 摩擦力和气体力作用在其后
word-relaxes-and-all-of-the-force-goes-through-it = 松弛，且全部力经过它
word-friction-in-the-rubber-and-all-of-the-force-goes-through-it = 橡胶内摩擦，且全部力经过它
word-rebound-chamber = 复原腔
word-both-chambers = 两腔
word-one-chamber-softer-than-the-other = 一腔比另一腔软
word-compression-capped-gas-pushes-on = 压缩力受限，气体继续推动
word-compression-capped-dead-return = 压缩力受限，回程无力
word-rebound-capped-force-stays = 复原力受限，力保持
word-rebound-capped-dead-return = 复原力受限，回程无力
word-compression-capped-gas-expands-in-the-void = 压缩力受限，气体在空穴中膨胀
word-foot-valve-does-not-refill = 底阀不补油
word-measured-temperature = 实测温度
word-oil-warmer-than-measured = 油温高于实测
word-heated-by-its-own-work = 自身做功发热
word-rebound-chamber-is-not-refilled = 复原腔未补油
word-rebound-begins-with-a-lost-stroke = 复原行程开始时有空程
word-compression-begins-with-a-lost-stroke = 压缩行程开始时有空程
word-isothermal = 等温
word-takes-time-to-cool = 冷却需要时间
word-both-strokes = 两个行程
word-groove = 沟槽
word-groove-open-in-rebound = 复原时沟槽开通
word-groove-open-in-compression = 压缩时沟槽开通
word-bypass = 旁通
word-filter = 滤波
word-stroke = 行程
word-a-valve-with-play = 有间隙的阀
word-a-valve-with-mass = 有质量的阀
word-opens-and-closes-at-different-forces = 开启力与关闭力不同
word-linear = 线性
word-quadratic = 二次
word-cubic = 三次
word-quartic = 四次
word-rubber = 橡胶
word-hydraulic-gap = 液压，环隙
word-hydraulic-orifice = 液压，节流孔
word-on-the-load-cell = 在力传感器上
word-at-the-load-cell = 在力传感器处
word-inside-like-oil-in-a-long-passage = 在内部，如长通道中的油液
word-low-pass-filter-of-the-force-channel = 力通道的低通滤波
word-zero-set-anew-during-the-campaign = 试验过程中重新调零
word-settles-as-the-rig-warms-up = 随试验台升温而稳定

## Words in sentences. Quantities of the dimensions, and units that are words.

word-gas-pressure = 气体压力
word-gas-volume = 气体体积
word-effective-modulus-of-the-oil = 油液有效模量
word-modulus-of-the-oil = 油液模量
word-air-content-of-the-oil = 油液含气量
word-bleed-area-in-rebound = 复原节流面积
word-bleed-area-in-compression = 压缩节流面积
word-leak-in-rebound = 复原泄漏
word-leak-in-compression = 压缩泄漏
word-blow-off-area-in-rebound = 复原开阀面积
word-blow-off-area-in-compression = 压缩开阀面积
word-gas-force = 气体力
word-growth-of-the-gas-force-with-temperature = 气体力随温度的增长
word-gas-stiffness = 气体刚度
word-length-of-the-gas-column = 气柱长度
word-cavitation-cap = 空化上限
word-stiffness-of-the-oil-column = 油柱刚度
word-shortening-of-the-oil-column = 油柱缩短
word-stiffness-of-the-oil-column-in-compression-over-that-in-rebound = 油柱压缩与复原刚度之比
word-force-that-halves-the-air-s-stroke = 使空气行程减半的力
word-stroke-that-the-air-yields = 空气让出的行程
word-series-stiffness = 串联刚度
word-parallel-spring = 并联弹簧
word-bar-gauge = bar（表压）
word-at-1-013-bar-absolute = %（绝对压力 1.013 bar 时）
word-fv-force-at-two-slow-speeds = 两个低速下的 fv_force
word-fv-force-at-a-fast-speed = 高速下的 fv_force
word-oil-stiffness-or-aeration-stroke = oil_stiffness 或 aeration_stroke
