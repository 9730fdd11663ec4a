### Texts of the reports: English.

## The page.

decimal-sign = .
note = Note.
all-tests-shown = all tests
previous = previous
next = next
test-shown = Test shown
figure-help = Drag over a figure to zoom, double-click to see all of it, move over it to read values.
zoom-reset = whole figure
save-table = save as CSV
save-about = Commas between columns, decimal points.
sort-help = Click a heading to sort.
printed-brief = Printed are the answer and its evidence. The file itself holds every test and table; a report made with --full prints them all.

## Figures.

measured = measured
model = model
fv-curve = FV curve
noise-alone = noise alone
axis-velocity = velocity, mm/s
axis-displacement = displacement, mm
axis-force = force, N
axis-error = simulated − measured, N
axis-time = time, s
axis-gap = rising − falling velocity, N
axis-error-percent = error, %
axis-peak-velocity = peak velocity, mm/s
axis-amplitude = amplitude, mm
plot-force-velocity = Force over velocity
plot-force-displacement = Force over displacement
plot-force-time = Force over time
plot-error-velocity = Error over velocity
plot-error-displacement = Error over displacement
plot-force-space = Force over velocity and displacement
plot-error-space = Error over velocity and displacement
plot-gap = Hysteresis gap over velocity
plot-error-of-tests = Error of every test, % of its largest force
plot-error-map = Error by amplitude and peak velocity, %
plot-error-map-note = large: { $model }, small: { $curve } alone
plot-both-curves = FV curves of both dampers, with friction and gas force
plot-peaks = Peak force over peak velocity
identified-curve = identified curve with friction and gas force
measured-peaks = measured peaks
model-peaks = model's peaks
window = limits

## Validation: title and answer.

title-validation = Damper model against rig records
subtitle-validation = Model { $model } against the rig data in { $data }
answer = Answer
over-one-test = In the one test
over-tests = Over { $tests ->
        [one] one test
       *[other] { $tests } tests
    }
headline = { $over } the model misses the measured force by { $error } N on average, { $percent } % of a test's largest force. The force–velocity curve alone misses it by { $curve_error } N, { $curve_percent } %: { $verdict }{ $closer }.
verdict-exact = the model follows the measurement exactly
verdict-smaller = the model's mean error is smaller by a factor of { $ratio }
verdict-same = the model gains nothing worth having over the curve
verdict-larger = the model's mean error is larger by a factor of { $ratio }: it does worse than the curve
closer-in = , and it is the closer of the two in { $closer } of { $tests ->
        [one] { $tests } test
       *[other] { $tests } tests
    }
left-out-figures = { $error } N or { $percent } % (curve alone { $curve_error } N or { $curve_percent } %)
left-out-sentence = On the { $left ->
        [one] test
       *[other] { $left } tests
    } that identification did not see the mean error is { $left_figures }; on the { $fitted } it was fitted to, { $fitted_figures }.
only-fitted = Every test was used to identify the model, so these figures show how well it fits, not how well it predicts.
largest-error = The largest error in percent is that of test “{ $test }”: { $percent } %, which is { $error } N of { $force } N.
noise-sentence = The noise of the measured force alone would give a mean error of about { $noise } N; no model can come closer than that.

## Its sections.

fv-section = FV curve over the measured peaks
fv-caption-by-setting = Each dot is the force of a test at its peak velocity, mean over its cycles, at the setting of the test.
fv-caption = Each dot is the force of a test at its peak velocity, mean over its cycles. The line is what the model gives at that velocity held constant: its FV curve, friction and gas force. Where dots leave the line, the damper depends on more than velocity.
worst-section = Worst test: { $test }
worst-caption = The test with the largest error in percent of its force.
matrix-section = Errors by amplitude and peak velocity
matrix-about = A row is in percent of the largest force of all its tests, also of those at another setting. A cell is the mean of its tests, each in percent of its own largest force, as in the figure of the tests. So a row with weak tests may be below its cells.
key-section = Errors in figures
tests-section = Errors of every test
single-section = Single tests
single-about = Sorted by error, the worst first. Loops show the last { $cycles ->
        [one] whole cycle
       *[other] { $cycles } whole cycles
    } of a test; a test without whole cycles is shown whole. Errors are simulated minus measured. The hysteresis gap is averaged over all whole cycles.
single-most = Of { $tests } tests the { $shown } with the largest errors are shown.
hysteresis-section = Hysteresis
identification-section = Identification
parameters-section = Model parameters
parameters-range = Low and high are the ends of the 95 % interval.
made-section = How this report was made

## Tables.

col-tests = tests
col-number = number
col-force-of = force of
col-mean-error = mean error, N
col-error-percent = error, %
col-region1 = region 1, N
col-region2 = region 2, N
col-rms = rms error, N
col-test = test
col-amplitude = amplitude, mm
col-frequency = frequency, Hz
col-peak-velocity = peak velocity, mm/s
col-max-force = largest force, N
col-in-fit = in fit
yes = yes
no = no
group-curve = FV curve alone
all-tests = all tests
used-in-fit = used in the fit
left-out-of-fit = left out of the fit
key-caption = Mean error: mean of |simulated − measured| over a test's samples. Error in percent of the largest measured force of the test. Regions 1 and 2: the parts of the mean error from samples slower and faster than { $boundary } mm/s; they add up to it. The rms error (root of the mean square) weighs large misses more. All are means over tests, each test with equal weight.
row-rule = Each test has equal weight in its row; the percent is of the largest force of the row.
by-amplitude = Tests of one amplitude together. { $rule }
by-peak-velocity = Tests of one peak velocity together. { $rule }
tests-caption = Every test by itself; the percent is of its own largest force.
row-amplitude = { $value } mm amplitude
row-peak-velocity = { $value } mm/s peak velocity
row-slow = slow friction tests, below { $value } mm/s
row-not-periodic = tests without whole cycles
col-cycles = cycles
group-gap = mean gap, N
group-gap-error = gap error, N
group-area = loop area ∮F dv, N·m/s
group-energy = energy ∮F dx, J
col-measured = measured
col-curve = curve
hysteresis-caption = Averages over whole cycles. Gap: the difference between the force at rising and at falling velocity, at equal velocity; its magnitude is averaged over the velocities of the test. Gap error: mean of |simulated gap − measured gap|. A negative loop area means that the force lags behind the velocity (gas and oil compressibility), a positive one that it leads (moving mass).
col-name = name
col-value = value
col-unit = unit
col-low = low
col-high = high
col-source = source
parameter-at = at { $place }
col-note = note
not-identified = not identified from this data
not-identified-assumed = not identified: assumed { $value }, { $source }
not-identified-off = not identified: its element is off ({ $why })
assumed-usual = what dampers show ({ $source })
assumed-dimensions = by the dimensions ({ $source })
assumed-default = the default of the model
assumed-held = the records do not determine it; it lies between the usual value and the best fit

## Single tests.

notes-of-test = What reading and cleaning did or noticed:
motion-periodic = { $amplitude } mm amplitude at { $frequency } Hz, peak velocity { $velocity } mm/s, { $cycles ->
        [one] { $cycles } whole cycle
       *[other] { $cycles } whole cycles
    }.
motion-other = Not periodic, peak velocity { $velocity } mm/s.
temperature = Temperature { $first } °C at the start, { $last } °C at the end.
force-noise = Force noise { $noise } N rms.
test-used = Used in the fit.
test-left-out = Left out of the fit.
test-sentence = Largest force { $force } N. Mean error of the model { $error } N, { $percent } %; of the force–velocity curve alone { $curve_error } N, { $curve_percent } %.

## The literature.

family-section = Over the setting
family-between = Left out as a test, { $at } is predicted by a family that did not see it. The error is { $error } N ({ $percent } %), { $ratio } times that of a fit of { $at } alone.
family-between-worse = Between its settings the model is uncertain. Left out as a test, { $at } is predicted by a family that did not see it. The error is { $error } N ({ $percent } %), { $ratio } times that of a fit of { $at } alone. The model itself contains { $at }. { $advice }
family-between-records = Records between { $at } and its neighbors would help most.
family-between-labels = Check the doubted settings of the tests first.
family-between-unknown = No setting could be left out, so the error between the settings is unknown; a third setting would show it.
family-about = The damper depends on a setting. Each test is simulated at its own setting. Between the settings of the model file, the numbers are interpolated.
family-interpolated = { $setting } (interpolated)
plot-family = Force at constant velocity, by setting
family-caption = One curve for each setting of the model file, dashed for settings of the tests between them. Dots are the measured forces at peak velocity, in the color of their setting.
family-table = Means over the tests of each setting. The FV curve is fitted to the tests of that setting. Each test is in percent of its own largest force.
family-clamped = { $setting } (clamped)
family-errors-section = Errors at each setting
family-left-out-table = Mean error over the mean cycles of the fitted tests. The family without a setting is refitted to all other settings and interpolated; at the ends of the grid there is none. Each test is in percent of its own largest force. A fit of one setting alone has fewer points of the FV curve, so the family may be better than it.
family-own-fit = fit of it alone
family-fit = family
family-without = family without it
col-ratio = ratio
family-loops-section = Loops by setting
family-loops-about = One motion at every setting that has it: { $amplitude } mm amplitude, peak velocity { $velocity } mm/s.
family-worst-about = Below, the test with the largest error in percent at each setting.
family-worst-caption = { $setting }: { $test }, mean error { $error } N, { $percent } %
plot-surface = Force over velocity and setting
surface-caption = Force of the model at constant velocity. Colored lines are the settings of the model file, gray lines are constant velocities and settings between them. Dots are the measured forces at peak velocity.
plot-over-setting = Force over the setting
over-setting-caption = Force of the model at constant velocity. A flat line does not depend on the setting.
plot-ratio = Ratio of hardest to softest
ratio-caption = Force at { $hard } over force at { $soft }, friction included, without the gas force, at the peak velocities that the tests reach.
axis-speed = speed, mm/s
axis-ratio = ratio, -
number-varies = (depends on the setting; bars are 95 % intervals, a value without a bar is not identified)
number-shared = (shared by all settings; bars are the 95 % interval)
family-numbers-section = Numbers over the setting
family-numbers-table = What depends on the setting, with 95 % intervals where a fit has left them.
family-varies = depends
family-effects = What each effect carries at each setting: what its removal changes, everything else kept.
family-dependences = What depends on the setting, with the probability that it does.
responses-section = Response to steps of the setting
responses-about = Along the motion of each test the force at the setting before a step and at the one after it are known from the model. The response is the fraction of the way between them that the force has gone. So a step counts during a sine as well as at constant speed.
responses-table = Mean response to all steps between the same two settings, measured and by the model. Times count from the step; those from 10 % leave the dead time out.
responses-late = The model does not follow all steps. Its force reaches 63 % later (+) or earlier (−) than measured, by more than the uncertainty of the measurement: { $steps }.
col-step = step
col-steps = steps
col-t63 = to 63 %, ms
col-t90 = to 90 %, ms
col-t63-from-10 = 10 to 63 %, ms
col-t90-from-10 = 10 to 90 %, ms
col-overshoot = overshoot, %
plot-step-up = Response to a step up
plot-step-down = Response to a step down
axis-since-step = time since the step, ms
axis-way = fraction of the way, -
actuator-table = Numbers of the actuator, with 95 % intervals where a fit has left them.
actuator-parts = What the valve has, with the probability that it does.
undecided = undecided
col-has-it = has it
plot-hysteresis-setting = Hysteresis over the setting
hysteresis-setting-caption = Force of the model at { $velocity } mm/s while the setting rises and falls slowly. The valve stands { $hysteresis } behind on the way up and ahead on the way down.
way-up = up
way-down = down
family-changing = changing
response-time-up = response to a step up, to 63 %, ms
response-time-down = response to a step down, to 63 %, ms
rise-time-up = response to a step up, 10 to 90 %, ms
rise-time-down = response to a step down, 10 to 90 %, ms
settings-section = Over the settings
settings-all = all
settings-caption = Every effect of the damper at the settings, each diagnosed by itself: probability and force at each. An effect of all settings stands once.
settings-changes = What changed against the reference at the settings, each compared by itself: value before and after, probability and force at each.
settings-answers = The answer at each setting. N rms over the mean cycles of its tests: before an effect is added, after, and what noise makes of it.
col-setting = setting
against-section = Against the literature
against-about = Every model is identified by least squares, with several starts, from the tests that the validated model was fitted to. It then predicts the tests left out. rms and mean error are means over tests.
against-caption = Error in percent of the largest measured force of each test.
col-model = model
col-meaning = what it is

## Limits.

certificate-title = Certificate: damper against its limits
certificate-subtitle = Rig data in { $data }, limits of { $limits }
certificate-section = Limits
certificate-pass = PASS. The damper keeps all limits ({ $count }).
certificate-fail = FAIL. The damper does not keep { $failed } of { $count ->
        [one] { $count } limit
       *[other] { $count } limits
    }.
certificate-fail-untested = FAIL. { $failed } of the { $tested ->
        [one] { $tested } limit
       *[other] { $tested } limits
    } tested { $failed ->
        [one] is
       *[other] are
    } not kept; { $untested } more could not be tested with these records: { $why }.
certificate-untested = INCOMPLETE. { $tested ->
        [one] The limit tested is
       *[other] The { $tested } limits tested are
    } kept; { $untested } more could not be tested with these records: { $why }.
certificate-nothing-tested = INCOMPLETE. { $count ->
        [one] The limit could not be tested
       *[other] None of the { $count } limits could be tested
    } with these records: { $why }.
certificate-why-untested = there is no test at that speed, or none slow enough for friction and gas force
certificate-why-untested-at-setting = there is no test at that speed and setting, none slow enough for friction and gas force, or no such step of the setting
certificate-unsure = { $verdict }, not sure: the measured time is known to ± { $value } ms
certificate-damping = { $verdict }; { $value } N of it grow with velocity, so they are damping
certificate-interpolated = { $tests }, interpolated
certificate-step = step from { $from } to { $to }: { $tests }
certificate-model-passes = The model gives the same answer to every limit.
certificate-model-fails = The model answers { $count ->
        [one] one
       *[other] { $count }
    } of the limits otherwise than the measurement, so a simulation shows another damper there.
certificate-caption = Forces are those at peak velocity, mean over the cycles of the test with the longest stroke that reaches the speed; interpolated linearly between two tests whose velocities differ by a factor of { $ratio } at most, else of a test within { $percent } % of the speed. Rebound and tension are positive, compression negative. Gas force and friction are mean and half difference of the strokes of the slow tests. Hysteresis is the mean gap between rising and falling velocity at equal velocity.
subject-part = Part: { $text }
subject-serial = Serial number: { $text }
subject-tester = Tested by: { $text }
subject-rig = Rig: { $text }
subject-measured = Measured: { $text }
subject-temperature = Temperature while measured: { $low } to { $high } °C
to-fill-in = ______________________________
col-limit = limit
col-at = at, mm/s
col-low-limit = low
col-high-limit = high
col-verdict = verdict
col-from = from test
pass = pass
fail = FAIL
not-tested = NOT TESTED
force-rebound = force, rebound
force-compression = force, compression
gas-force = gas force
friction = friction
hysteresis = hysteresis

## How it was made.

made-version = Written by dashpot { $version }.
made-date = Date: { $date }.
made-command = Command: { $command }
made-again = The same version, command and files give the same figures again. The hash is SHA-256, as sha256sum prints it.
col-file = file
col-bytes = bytes
made-all = { $count ->
        [one] The file
       *[other] All { $count } files together
    }: SHA-256 { $hash } (of the lines that sha256sum prints of them, in this order).
made-files = Files read.

## Manoeuvres.

manoeuvre-title = Manoeuvre { $name }
manoeuvre-subtitle = Model { $model } against its FV curve, { $step } s steps
manoeuvre-answer = With the model the largest damper force is { $force } N, with its FV curve alone { $curve } N, both at { $corner }; the forces there differ by { $difference } N rms, { $share } % of the rms force.
manoeuvre-answer-same = The model and its FV curve give the same forces in this manoeuvre.
manoeuvre-beyond = The damper { $corner } moves at { $saw } mm/s; its FV curve was identified at { $ends } mm/s and goes straight on beyond, { $share } % of the time.
manoeuvre-quiet = In steps of { $host } ms the exchange of force and motion chatters: it adds up to { $curve } N rms to the force with the FV curve and { $model } N to that with the model. Differences of force and heave are therefore those of steps of { $quiet } ms; all else is as the host computes it.
manoeuvre-chassis = Heave acceleration of the body: largest { $peak } m/s² (FV curve { $peak_curve }), rms { $rms } m/s² (FV curve { $rms_curve }); heave differs by { $heave } mm rms.
corner-section = Damper forces
corner-force-velocity = { $corner }: force over velocity
corner-force-time = { $corner }: force over time
corner-difference = { $corner }: model less FV curve
axis-difference = model − FV curve, N
corners-table = Corners in figures
corners-caption = What every damper saw and gave. L1 is front left, R2 rear right.
col-corner = corner
group-largest-force = largest force, N
group-energy-j = energy, J
col-rms-difference = rms difference, N
road-section = Road and speed
road-caption = The road under the front wheels, left and right. The vehicle drives at { $speed } km/h.
plot-road = Road under the front wheels
axis-road = road height, mm
chassis-section = Chassis
plot-heave = Chassis displacement
plot-heave-acceleration = Chassis acceleration
plot-roll = Roll
plot-lateral = Lateral acceleration
axis-heave = heave, mm
axis-heave-acceleration = heave acceleration, m/s²
axis-roll = roll, °
axis-lateral = lateral acceleration, m/s²
region-section = Operating region
region-with-tests = Where the dampers worked, over the loops that the rig tests measured. Outside them the model is not checked.
region-without-tests = Where the dampers worked. With --tests the loops of the rig tests are drawn below.
plot-region = { $corner }: operating region
in-vehicle = in the vehicle
rig-tests = rig tests
vehicle-section = Vehicle
vehicle-caption = The vehicle driven. With --vehicle car.toml any of these names may be given another value.
wheel-left = left
wheel-right = right
coupling-unstable = c h / m reaches { $moving } on the { $mass } kg wheel (c: slope of force over velocity, h: step): a simulator that exchanges force and motion with one step of delay is unstable above 1, without delay above 2; a shorter step helps.
coupling-chatter = c h / m (c: slope of force over velocity, h: step) is at most { $moving } on the { $mass } kg wheel in motion, but { $all } where friction turns over (below { $slow } mm/s): there the exchange chatters within the friction force; a shorter step or less steep friction helps.
col-near-tests = near rig tests, % of time
saw-displacement = displacement, mm
saw-velocity = velocity, mm/s

## The workbook.

workbook-contents = Contents
workbook-sheet = sheet
workbook-about = what it shows

## What a fit found.

fit-title = What the fit found
fit-subtitle = Model { $model } from the rig data in { $data }
fit-answer = { $tests ->
        [one] One test
       *[other] { $tests } tests
    } fitted, off by { $error }.
quality-sentence = { $grade }: the model misses the measured force by { $error } N on average ({ $percent } % of the largest force), { $beside }; { $curve }.
quality-noise = As good as the noise allows
quality-good = Good fit
quality-fair = Fair fit
quality-poor = Poor fit
quality-beside-noise = { $ratio } times the noise of the records ({ $noise } N)
quality-beyond-noise = { $ratio } times the noise of the records ({ $noise } N), so the tests show more than the model has
quality-noise-unknown = the noise of these records is not known
quality-curve-worse = the FV curve alone misses it by { $error } N ({ $percent } %), { $ratio } times as much
quality-curve-no-worse = the FV curve alone is about as good or better, { $error } N ({ $percent } %)
quality-worst = In percent, it is worst in { $test }: { $error } N on average ({ $percent } % of the largest force of that test; the FV curve alone { $curve } N).
fit-measured = What the measurement is off by
fit-tests = Tests fitted
remarks = Remarks
col-why = why
col-interval = 95 % interval

## Of figures and tables everywhere.

comma = ,{ " " }
sentence-end = { $sentence }.
semicolon = ;{ " " }
colon = :{ " " }

## The direction that the files count positive.

sign-given = The files count { $direction } positive, as given.
sign-found = The files count { $direction } positive ({ $percent } % sure).
sign-found-by = The files count { $direction } positive ({ $percent } % sure): { $reasons }.
range = { $low } to { $high }
before = before
after = after

## Figures before and after.

axis-residual = measured − computed, N
axis-residual-rms = rms of measured − computed, N
axis-resistance = resistance measured − computed, N
axis-since-reversal = time since reversal, ms
axis-error-rms = error, N rms
plot-error-rms = Error of every test, N rms
plot-left-velocity = What is left, over velocity
plot-left-size = Size of what is left, over velocity
plot-left-up = Mean of what is left, speeding up
plot-left-down = Mean of what is left, slowing down
plot-left-reversal = Mean of what is left, after a reversal
plot-left-map = Mean of what is left, over velocity and displacement
fitted-tests = fitted tests
left-out = left out
stretch = { $test } ({ $place } of { $count })

## Diagnosis: title and answer.

diagnosis-title = Where model and records disagree, and what is missing
errors-caption = Each column is one test: how far the computed force is from the measured one before (grey) and after (red). A red dot on the bar means that nothing but noise is left. Left-out tests were seen by no refit: what closes there is real.
error-unseen = On the { $tests ->
        [one] test
       *[other] { $tests } tests
    } that no refit has seen, the error goes from { $before } to { $after } N rms
error-fitted = No test was left out (too few, or none named), so these figures show how well the model fits, not how well it predicts: the error goes from { $before } to { $after } N rms
rating-left-out = { $grade }: on the left-out tests the model misses the measured force by { $error } N rms, { $ratio } times their noise.
rating-fitted = { $grade }: on the fitted tests the model misses the measured force by { $error } N rms, { $ratio } times their noise.
gap-is-closed = { $error }; { $gap } of the gap between model and noise is closed, each test counted in units of its own noise.
gap-grows = { $error }; the gap between model and noise grows by { $gap }, each test counted in units of its own noise.
nothing-stays = The model stays as it is; only its numbers were refitted.
changed-stays = The model keeps its form; its numbers are this damper's now.
nothing-added-rivals = Nothing was added: a guess between names that explain the records equally well would be worth nothing. The suspects are below, and the tests that would decide.
nothing-added-unknown = Nothing was added: the disagreement is described below without a name. Its shape over velocity, displacement and time says what to look for at the damper or at the rig.
worse-tests = { $count } of { $all } left-out tests { $count ->
        [one] is
       *[other] are
    } further off than before, the first is { $test }.
row-before = before (the model as it came, refitted)
col-fitted-rms = fitted tests, N rms
col-their-noise = noise of these, N rms
col-left-out-rms = left-out tests, N rms
mean-cycles-caption = On mean cycles, which have less noise than single ones. Error in percent: mean |computed − measured| of a test over its largest force, mean over all tests.
whole-deviation = { $error } N mean ({ $percent } %)
whole-records = Over every sample of all records, as dashpot validate measures: { $came } as the model came, { $refitted } refitted, { $improved } improved. The figures above are of mean cycles, in which noise is averaged out.
whole-records-refitted = Over every sample of all records, as dashpot validate measures: { $came } as the model came, { $refitted } refitted. The figures above are of mean cycles, in which noise is averaged out.
whole-records-other = As it came, the model misses these records by { $came }; refitted to them, by { $refitted }. So it describes another damper, another setting or another temperature, and its numbers moved.

## The picture of a diagnosis.

name-and-sure = { $name } ({ $sure } sure)
picture-named = This damper shows: { $names }
picture-nothing = No known effect is missing
picture-cannot-tell = Something is missing, and these records cannot tell what
picture-unknown = Something is missing that no known effect explains
picture-below = Above: test { $test }, { $kind }. Below: every test.
kind-left-out = left out of every refit
kind-fitted = fitted

## Where they disagree.

where-section = Where they disagree
no-region = No region stands out of the noise.
left-map-caption = Measured less computed force, averaged over all tests, in every place of velocity and displacement they reach; both maps have one colour scale. A stripe along zero velocity is friction, a slope along displacement a spring or gas, opposite signs at equal velocity a lag. Both axes give the part near zero more room.
left-size-caption = How large the rest is at each velocity. Where red lies on the pale line, nothing but noise is left.
left-reversal-caption = What follows a reversal: below zero the damper builds its force up later than computed (compliance, play, presliding, late channel), above zero it resists more (break-away).
speeding-up-caption = The same velocity while the stroke gathers speed …
slowing-down-caption = … and while it loses it. Where the two differ, a hysteresis is missing or too large.
all-there = all that go there
rebound = rebound
compression = compression
speeding-up = speeding up
slowing-down = slowing down
both = both
col-direction = direction
col-speed = speed
col-mean-n = mean, N
col-rms-n = rms, N
col-noise-n = noise, N
col-in-words = in words
regions-caption = Measured less computed force of the model as it came (refitted), over the fitted tests: regions that stand out of the noise, those of all tests first, then the worst.

## What is missing.

findings-section = What is missing
suspects-section = Suspects
suspects-cannot-tell = One of these is missing, likeliest first.
suspects-beside = What may be missing beside that, likeliest first; none is likely enough to be added.
suspects-nearest = What comes nearest; none is likely enough to be named.
rig-added = The rig added to the measurement: { $all }. That is corrected in this comparison only and is not part of the improved model; put the rig right before the next campaign.
changed-section = Numbers that are others than on the reference damper
inventory-section = Inventory
col-force-rms = force, N rms
col-share-of-force = fraction of the force
col-status = status
status-kept = kept
status-added = added
status-added-unnamed = added, not named
status-replaced = replaced
status-removed = removed
replaces = in place of { $effect }
or-instead = or { $effect } in its place ({ $probability })
inventory-caption = Every effect of the given and of the most probable model. The force of an effect is what its removal changes, everything else kept.
other-effects = further effects
plot-inventory = Force of each effect, N rms
axis-effect-force = force, N rms
inventory-bands-caption = Root mean square over the fitted tests of a band, side by side. Forces of opposite phase cancel in part, so a bar may exceed the sum.
shifts-section = Numbers of the model that moved
finding-heading = { $place }. { $effect }{ $form }: { $sure } sure
finding-form = , form { $form }
finding-gap = { " " }Without it { $gap } of the gap opens again.
finding-disagreement = { " " }Without it { $gap } of the disagreement opens again.
finding-of-rig = It is of the rig, not of the damper: corrected in the comparison, not put into the model.
finding-added = It is added to the improved model.
finding-what = { $meaning }. { $added }{ $gap }
finding-why = Where: { $path } (family { $family }, { $family_sure } sure). With it the residual is smaller in { $tests } of the tests.
rivals-caption = What else was tried in its place.
col-parameter = parameter
col-judged = judged
plausible = plausible
not-plausible = outside what dampers and rigs show: treat with care
col-effect = effect
col-confidence = confidence
col-explains = explains
col-reference = reference
col-this-damper = this damper
changed-caption = Changes are sorted by the force that they make in the tests.
col-change = change
shifts-caption = Without the effect these numbers had taken a part of it up. Shown are those that moved by more than three standard deviations.

## Loops.

loops-section = Loops before and after
more-loops-section = Loops of other tests
loops-about = The tests whose disagreement before is the largest share of their force. Blue is the measured mean cycle, grey the model refitted to these tests, red the improved one; the third figure magnifies what is left of the force.
loop-heading = { $test }, { $kind }
loop-errors = Error { $before } N rms before, { $after } N after; noise alone makes { $noise } N.{ $closed }
loop-closed = { " " }{ $gap } of the gap is closed.
loop-grown = { " " }The gap grows by { $gap }.

## Errors by amplitude and peak velocity, before and after.

map-before = Error before, % of largest force
map-after = Error after, % of largest force
map-before-caption = One cell per amplitude and peak velocity; dark is far off.
map-after-caption = The same with what was found, in the same colours.
mean-cycles-rule = Each test has equal weight in its row; the percent is of the largest force of the row. Errors of mean cycles: noise is smaller than in dashpot validate, which compares every sample.

## Everything that was tried.

tried-section = Everything that was tried
tried-about = In each look every form of every effect is added to the model and all numbers are refitted with it, from several starts. What was named is in that model: its rows stand first and compare the model with and without it. Explains: share of the mean square beyond the noise. Error left: mean over the tests, in units of what noise and the form of curves leave. Log odds: how many more times the records are likely with it, as a natural logarithm, each test counted as one independent sample and its numbers paid for. Strange numbers: what values that dampers hardly show cost it, in the same units. Probability is that of the effect, over all its forms.
col-form = form
col-probability = probability
col-error-left = error left
col-log-odds = log odds
col-strange = strange numbers
col-tests-better = tests better
look = Look { $number }.

## What to measure next.

limits-section = What to measure next
next-tests-section = Tests worth running next
cannot-show-section = What these records cannot show
all-would-show = Every known effect would have shown in these records.
col-cannot-show = why, and what would show it
cannot-show-caption = Neither found nor ruled out.
col-next-amplitude = amplitude, mm
col-next-frequency = frequency, Hz
col-next-mean = mean position, mm
col-side-force = side force, N
col-difference-rms = difference, N rms
col-what-to-do = what to do
next-tests-caption = Difference: by how much the explanations' predictions differ there. A test decides where that is well above the noise.

## Parameters of the improved model.

source-refitted = refitted
source-added = added: { $effect }

## Many dampers.

groups-title = What changed between dampers
groups-subtitle = Model { $model } against each group; reference: { $reference }
groups-section = What changed in which group
groups-caption = Every group beside the reference. N rms over the mean cycles of the tests, the model refitted: before a name is added, after, and what noise makes of it.
group-against = { $group }, against { $reference }
group-note = { $groups }: { $text }
col-group = group
col-answer = answer
col-named = named
col-before-n = before N
col-after-n = after N
col-group-noise = noise N
no-change = no change beyond the intervals
not-compared = not compared: these records do not show it
other-groups = further groups
plot-group-curves = FV curves of all groups
group-curves-caption = Force of every damper moving steadily, with friction and gas, as far as its tests reach; dashed: the reference.
numbers-section = Numbers that changed
numbers-caption = Numbers of the model that differ from the reference in at least one group by more than both leave open. Below them, the numbers of the effects that were named.
col-quantity = number
measurement-section = The measurement itself
aside-section = Left aside
aside = Tests that belong to no group: { $tests }.
without-test = Lines of the list of groups that name nothing in the data: { $tests }.

# Names of effects, elements and parameters are short, and without commas, since they stand in lists.

## Names. Effects and elements.

name-fv-curve = FV curve
name-gas-preload = constant gas force
name-gas-spring = gas spring
name-coulomb-friction = dry friction
name-stribeck-friction = friction with break-away
name-presliding-friction = presliding friction
name-viscous-friction = viscous friction
name-side-force-friction = friction by side force
name-series-compliance = series compliance
name-bushing = rubber bush
name-parallel-spring = parallel spring
name-oil-compressibility = compressible oil
name-aeration = air in the oil
name-cavitation = cavitation
name-gas-warming = gas force over temperature
name-temperature-fade = fading with temperature
name-position-dependent-damping = damping that depends on the position
name-bump-stop = bump stop
name-rebound-stop = rebound stop
name-free-play = free play
name-frequency-selective-damping = frequency-selective damping
name-valve-hysteresis = valve hysteresis
name-moving-mass = moving mass
name-lagged-polynomial = polynomial with lag
name-integration = integration
name-cylinder-expansion = widening of the cylinder

## Names. Effects of the rig, and what looks like something that has no name.

name-channel-delay = delay of the force channel
name-force-offset = zero error of the load cell
name-force-drift = zero drift of the load cell
name-gain-drift = gain drift of the force channel
name-load-dependent-friction = friction that grows with the load
name-load-cell-hysteresis = hysteresis of the load cell
name-resonance = resonance

## Names. Their numbers.

name-delay = delay
name-rig-mass = mass on the load cell
name-offset = zero error
name-drift = drift
name-whole-drift = drift in all
name-share = ratio
name-share-across = quadrature ratio
name-share-growth = growth of the ratio
name-cooling-rate = cooling rate

## Names. Parts of the FV curve that change as one.

name-rebound-curve = rebound force
name-compression-curve = compression force
name-rebound-low-speed = rebound force at low speed
name-compression-low-speed = compression force at low speed
name-rebound-high-speed = rebound force at high speed
name-compression-high-speed = compression force at high speed

## Names. The FV curve.

name-fv-form = form of the FV curve
name-fv-interpolation = interpolation of the FV curve
name-fv-velocity = velocity of the FV curve
name-fv-force = force of the FV curve
name-fv-rebound-c1 = first rebound slope
name-fv-rebound-c2 = second rebound slope
name-fv-rebound-c3 = third rebound slope
name-fv-rebound-v1 = first rebound knee
name-fv-rebound-v2 = second rebound knee
name-fv-compression-c1 = first compression slope
name-fv-compression-c2 = second compression slope
name-fv-compression-v1 = compression knee

## Names. In series.

name-series-stiffness = series stiffness
name-series-damping = series damping
name-internal-mass = internal mass
name-series-load = load of the series spring
name-free-play-gap = size of the play
name-free-play-load = load on the play
name-free-play-force = softness of the contact
name-bushing-hardening = hardening of the rubber
name-bushing-loss-stiffness = dynamic stiffening of the rubber
name-bushing-loss-time = relaxation time of the rubber
name-bushing-slip = slip travel of the rubber
name-bushing-stop = travel of the rubber to its stop
name-bushing-stop-stiffness = stiffness of the rubber’s stop
name-bushing-slow-stiffness = slow stiffening of the rubber
name-bushing-slow-time = slow relaxation time of the rubber

## Names. Oil.

name-oil-stiffness = stiffness of the oil column
name-oil-shortening = shortening of the oil column
name-oil-chambers = compressible chambers
name-oil-compression = oil stiffness ratio of compression
name-aeration-stroke = stroke absorbed by air
name-aeration-force = force that closes the air
name-aeration-compression = air ratio of compression
name-cavitation-force = cavitation limit
name-cavitation-side = stroke that cavitates
name-cavitation-return = force on the return
name-cavitation-form = form of the cavitation
name-cavitation-velocity = speed limit of the foot valve
name-cavitation-unfilled = unfilled fraction of the flow
name-lost-stroke = lost stroke
name-cavitation-onset = onset of the cavitation
name-cavitation-expansion = expansion of the void

## Names. Over the stroke.

name-bypass-share = force reduction in the zone
name-bypass-centre = center of the zone
name-bypass-half-width = half-width of the zone
name-bypass-blend = transition of the zone
name-bypass-strokes = strokes of the zone
name-bypass-form = form of the zone
name-bypass-flow = flow through the groove

## Names. Heat.

name-fade-source = source of the temperature
name-fade-coefficient = damping decrease per kelvin
name-fade-reference = reference temperature
name-heat-capacity = heat capacity
name-heat-transfer = heat flow per kelvin
name-fade-laminar-force = laminar force limit
name-fade-slackening = temperature dependence of the decrease

## Names. Valves.

name-fsd-form = form of the frequency dependence
name-fsd-share = force fraction lost at high frequency
name-fsd-time = time constant of the frequency dependence
name-fsd-velocity = filling speed of the chamber
name-fsd-flow = bypass flow
name-fsd-force = filling force of the chamber
name-fsd-laminar-force = laminar limit of the bypass
name-valve-hysteresis-share = force fraction added by the valve lag
name-valve-opening-force = opening force of the valve
name-valve-closing-ratio = closing to opening force
name-valve-time = time constant of the valve
name-valve-width = opening range of the valve
name-valve-form = form of the valve hysteresis
name-valve-play = play of the valve
name-valve-damping = damping ratio of the valve

## Names. Springs.

name-spring-linear = linear spring rate
name-spring-quadratic = quadratic spring rate
name-spring-cubic = cubic spring rate
name-spring-quartic = quartic spring rate
name-spring-displacement = displacement of the spring table
name-spring-force = force of the spring table

## Names. Friction.

name-coulomb-force = friction force
name-coulomb-steepness = steepness of the friction
name-stribeck-form = Stribeck form
name-stribeck-breakaway-force = break-away force
name-stribeck-coulomb-force = friction after break-away
name-stribeck-breakaway-velocity = break-away velocity
name-stribeck-velocity = Stribeck velocity
name-stribeck-fall = exponent of the decrease
name-stribeck-rise = steepness of the rise
name-stribeck-rise-power = exponent of the rise
name-viscous-coefficient = viscous coefficient
name-side-force-coefficient = friction per side force
name-side-force-steepness = steepness of the side-force friction
name-presliding-force = presliding friction force
name-presliding-length = presliding travel
name-presliding-power = shape of the presliding
name-presliding-return = return after a reversal
name-presliding-creep = creep velocity

## Names. Gas.

name-gas-force = gas force
name-gas-warming-rate = growth of the gas force per kelvin
name-gas-warming-reference = reference temperature of the gas force
name-gas-stiffness = gas stiffness
name-gas-length = length of the gas column
name-gas-adiabatic-index = adiabatic index
name-gas-thermal-time = thermal time of the gas

## Names. The model of the literature.

name-polynomial = coefficients of the polynomial
name-lag-slow = lag at low speed
name-lag-fast = lag at high speed
name-lag-v1 = lower speed of the lag
name-lag-v2 = upper speed of the lag

## Names. Masses and stops.

name-moving-mass-time = lag of the moving mass
name-moving-mass-place = place of the moving mass
name-bump-stop-clearance = travel to the bump stop
name-bump-stop-stiffness = stiffness of the bump stop
name-bump-stop-progression = progression of the bump stop
name-bump-stop-loss = loss of the bump stop
name-bump-stop-damping = damping of the bump stop
name-bump-stop-flow = flow of the bump stop
name-rebound-stop-clearance = travel to the rebound stop
name-rebound-stop-stiffness = stiffness of the rebound stop
name-rebound-stop-progression = progression of the rebound stop
name-rebound-stop-loss = loss of the rebound stop
name-rebound-stop-damping = damping of the rebound stop
name-rebound-stop-flow = flow of the rebound stop

## Names. The step.

name-method = method of integration
name-substeps = substeps

## Choices of a parameter: they stand in a list of a narrow panel.

choice-automatic = automatic
choice-both = both
choice-bypass = bypass
choice-cap = limited force
choice-compression = compression
choice-cubic-each-side = cubic each side
choice-driven-end = moving end
choice-elastic = elastic return
choice-euler = Euler
choice-factor = factor
choice-filter = filter
choice-foot-valve = foot valve
choice-fourth-order = fourth order
choice-full = full
choice-gap = gap
choice-groove = groove
choice-hydraulic = hydraulic force
choice-inside = inside
choice-linear = linear
choice-measured = measured
choice-monotone-cubic = monotone cubic
choice-opening = opening
choice-orifice = orifice
choice-piecewise = straight pieces
choice-play = friction of the spool
choice-rebound = rebound
choice-second-order = second order
choice-self-heating = self-heating
choice-simplified = simplified
choice-slips = slips at once
choice-spool = mass of the spool
choice-stroke = within each stroke
choice-table = table
choice-third-order = third order
choice-three-stage = three stages
choice-whole = whole force
