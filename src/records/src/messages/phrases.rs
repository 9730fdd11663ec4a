//! All English texts of the messages about records in one list. A test finds texts without a translation.

dashpot_messages::phrases! {
    "records-";
    // Lists.
    COMMA: ", ";
    SEMICOLON: "; ";
    QUOTED: "'{test}'";
    AND_MORE: "{names} and {count} more";
    OR: " or ";
    // Files and tables.
    PROFILE: "read as {file} says";
    STRAY: "in {folder}, not read as records: {names}";
    BELOW: "the subfolders of {folder} hold {count|# file that was|# files that were} not read ({names}); where they are tests of the same damper, --subfolders reads them too";
    COLUMNS_NOT_READ: "columns not read: {names}";
    BY_UNIT: "'{column}' is taken for {channel} by its unit alone; --column says if another one is meant";
    UNREAD_CURRENT: "column '{column}' in {unit} is not read; if it is the current of the damper's valve, give --column current='{column}', otherwise --ignore current";
    CONVERTED: "converted to SI: {channels}";
    FROM_UNIT: "{channel} from {unit}";
    TIME_OF_DAY: "time of day taken from the first row on";
    ONE_CLOCK: "the records are put on one clock by the date and time that their files bear, from {first} to {last}: heat and drifts carry over from file to file";
    DATES_ASSUMED: "the date {date} (of {at}) may have the day or the month first, and nothing in the files decides it; it was read as {read}, {why}. --dates day-first or month-first says which (dates in campaign.toml)";
    DATES_CLOSE: "for so the tests lie close together";
    DATES_AMERICAN: "with the month first, as between strokes in America";
    DATES_USUAL: "with the day first, as is usual between hyphens";
    OWN_CLOCKS: "every record has a clock of its own, so that heat and drifts do not carry over from file to file: {why}";
    SOME_WITHOUT_DATE: "only {count} of {all} files {count|bears|bear} the time at which the test began";
    TOO_FAR_APART: "by the times that their files bear they are too far apart to be one campaign";
    CLOCKS_OVERLAP: "by the times that their files bear they overlap; these may be the times of an export";
    TWO_RATES: "measured at a higher rate in a group of its own, and joined at the times of the slower channels by straight lines: {names}";
    CUT_OFF: "the file broke off while it was written, so data are missing at its end; the {rows|whole row|# whole rows} before {rows|was|were} read. Measure the test again where it should have been longer";
    STALE_ROWS: "the first {count|row|# rows} (up to line {line}) {count|belongs|belong} to an earlier run, for time goes back from {from} s to {to} s behind; left out";
    CRANK: "time is worked out from the angle of the crank at {rpm} revolutions per minute";
    RESAMPLED: "measured at another rate, and put onto the times of force and motion by straight lines: {names}";
    BELOW_HEADING: "line {line}, below the heading, holds no figures: {text}";
    BELOW_TABLE: "from line {line} on, below the table, not read: {text}";
    BETWEEN_ROWS: "{count|# line between the rows holds no figures and was|# lines between the rows hold no figures and were} passed over (line {lines}), the first: {text}";
    BEHIND_ROWS: "{count|# row holds|# rows hold} text behind the columns of the heading, which was not read (line {lines}), the first: {text}";
    LONGER_ROWS: "{count|# row holds|# rows hold} more figures than the heading has columns, so that it is not sure which is which; {count|this row is|these rows are} left out (line {lines}). Too many in the first: {text}";
    // Gaps in time.
    OF_FILE: "{file}: {text}";
    GAPS: "gaps in time: {places}{more}. Read as {count|# test|# tests}{rest}";
    GAP: "{seconds} s without samples after {from} s (line {line})";
    MORE_GAPS: " and {count} more";
    TOO_FEW_BETWEEN: "; {count|# sample between gaps is|# samples between gaps are} too few for a test";
    STUMPS: "{count|# piece beside a gap holds no whole cycle and was|# pieces beside a gap hold no whole cycle and were} left out: {places}";
    FROM_TO: "{from} to {to} s";
    AT_SPEEDS: "{count} tests one after the other, strokes of constant speed told apart where the speed changes; the clock goes on, so that heat carries over";
    SPEED_OF_STROKES: "velocity is the speed of each whole stroke, for a stroke has too few samples for a course of it";
    AT_SETTINGS: "{count} tests one after the other without a rest, told apart where stroke or frequency changes and stays; the clock goes on, so that heat carries over";
    AT_RESTS: "{count} tests one after the other, told apart at the rests between them by the motion before and after; the rests are cut off around whole cycles, and the clock goes on, so that heat carries over";
    // Rows.
    ROWS_DROPPED: "{count} of {rows} rows dropped for empty or not-a-number cells (line {lines})";
    SETTING_HELD: "{count} of {rows} values of the setting '{setting}' {count|is|are} missing; each is taken as the one before it";
    SETTING_START: "the setting '{setting}' is on its way to its value for {seconds} s; this start was cut off";
    SETTING_EMPTY: "the column of the setting '{setting}' is empty: the test counts as one without it, or as its name says";
    SMALL_CURRENT: "the current is at most {current} mA, which counts as 0 A, for no valve answers to it; where the column holds A, give --unit current=A";
    FILLED: "{count|# missing value|# missing values} of {channel} filled by straight lines";
    EMPTY_COLUMN: "the column of {channel} is empty and was left out";
    REPEATED_ROWS: "{count|# row|# rows} in {blocks|# block|# blocks} {count|repeats an earlier row with its time stamp|repeat earlier rows with their time stamps}, first at line {line}; removed";
    REPEATED_BLOCKS: "{blocks|# block|# blocks}, {rows|# row|# rows} in all, {blocks|repeats|repeat} the rows just before under new time stamps (first: {first|# row|# rows} from line {line}); removed and the time behind closed up";
    OUT_OF_ORDER: "time stepped back {count|once|# times}, first at line {line}; {moved|# row|# rows} put back in order";
    SHARED_STAMPS: "{count} of {rows} rows shared a time stamp with the row before; {count|it was|they were} spread evenly to the next stamp";
    // Samples.
    CLIPPED_MOTION: "{channel} is clipped at {value} {unit} in {percent} % of the samples, first at line {line}; the channel is left out and derived from {other}";
    ROUNDED: "{channel} stands at {value} {unit} in {count|# sample|# samples}, first at line {line}; other tests go further, so that this is taken for a turn and not for the end of the range";
    CLIPPED_FORCE: "force is clipped at {value} N, first at line {line} (samples: {count}, {percent} %); these samples are left out";
    SPIKY: "{channel} is spiky: {percent} % of the samples stand off their neighbours; too many to be stray spikes, left as they are";
    SPIKES: "spikes of {channel} replaced by straight lines, first at line {line}, largest {largest} {unit} off (spikes: {spikes}, samples: {count})";
    // Motion.
    CONSISTENT: "velocity is {gain} times the derivative of displacement and {lag} ({percent} % of the displacement's variance unexplained)";
    NO_LAG: "has no lag";
    LAGS: "lags it by {lag} ms";
    LEADS: "leads it by {lag} ms";
    DIFFERENTIATED: "velocity derived from displacement by local cubics over {points} samples ({window} s), zero phase, -3 dB at {frequency} Hz{shorter}";
    SHORTER: "; over fewer where the motion turns within them, {percent} % of the samples";
    INTEGRATED: "displacement integrated from velocity, starting at {start} mm; velocity offset {offset} mm/s removed, which is a drift of {drift} mm over the record ({basis})";
    NOT_PERIODIC_ENDS: "the record is not periodic, so the damper is taken to end where it began";
    CYCLES_RETURN: "from whole cycles, in each of which the damper returns";
    // The user's corrections of the sensors.
    FORCE_ZERO: "force zero of {force} N taken off, as given";
    GAIN: "force multiplied by {gain}, as given";
    DISPLACEMENT_ZERO: "displacement zero of {displacement} mm taken off, as given";
    FORCE_TURNED: "sign of force turned, as asked";
    MOTION_TURNED: "sign of displacement and velocity turned, as asked";
    GAIN_OF: "{channel} multiplied by {gain}";
    MASS_TAKEN_OFF: "force that moves a mass of {mass} kg on the load cell taken off, as given";
    EARLY_AS_GIVEN: "force comes {delay} ms before the motion, as given; the motion was moved there, the force samples are as recorded";
    LATE_AS_GIVEN: "force comes {delay} ms after the motion, as given; the motion was moved there, the force samples are as recorded";
    TAKEN_OUT: "what the fit found the measurement to be off by was taken out";
    // Cycles.
    NO_CYCLES: "no whole cycles found; the record is kept whole ({samples|# sample|# samples})";
    TRIMMED: "cut {before} s ({samples_before|# sample|# samples}) of rest and run-up before the first whole cycle and {after} s ({samples_after|# sample|# samples}) after the last ({tail}); {cycles|# cycle|# cycles} at {frequency} Hz kept";
    UNLIKE_CYCLES: "in {places} places between the cycles the motion is no whole cycle like the others (pause or disturbance); kept in the record, left out of its cycles";
    NOISY_LAST: "the last cycle (from {start} s) deviates from the others by {last} N rms where they deviate by {typical} N; left out";
    DISPLACEMENT_DRIFTS: "mean displacement drifts by {drift} mm over {cycles|# cycle|# cycles} ({percent} % of the stroke); left as it is";
    FORCE_DRIFTS: "mean force drifts by {drift} N over {cycles|# cycle|# cycles} ({percent} % of its range); left as it is";
    // Values that are too small for a damper.
    NO_FORCE: "the force shows nothing but noise in {tests}; check the load cell, or leave these tests out";
    SMALL_AMPLITUDE: "the largest amplitude is {amplitude} {unit}: is the unit of displacement right?";
    SLOW: "the fastest test reaches {velocity} {unit}: are the units of time and motion right? From slow tests alone a model knows nothing of driving";
    SMALL_FORCE: "the force never changes by more than {force} N: is its unit right?";
    TORN: "{test}: holds less than one cycle and ends in the middle of a stroke, at {velocity} mm/s of at most {peak} mm/s; if the file broke off, export it again, or leave it out with --exclude";
    TWINS: "{test} holds the same samples as {twin} and counts twice";
    // Delay of the force.
    LATE: "the force comes about {delay} ms after the motion: taken so, a curve over velocity leaves {left} % of its variance unexplained, as recorded {recorded} %";
    LATE_NOT_MOVED: "{late}{energy}. Hysteresis looks like a delay here, so nothing was moved. dashpot fit tells them apart and reports the delay that it finds; what remains is hysteresis of the damper. Give {option} only if the rig is known to delay the force by that much";
    WOULD_FEED: "; as recorded, the damper would feed energy in {count} of {all|# test|# tests}";
    // The positive direction of the files.
    STANDSTILL: "force at standstill is {force} N ± {error} N as counted in the files; gas pushes the rod out, so that {verdict}";
    SPEAKS_FOR_TENSION: "speaks for tension positive (rebound)";
    SPEAKS_FOR_PUSH: "speaks for push positive (compression)";
    TOO_SMALL_TO_TELL: "is too small to tell the direction";
    NO_STANDSTILL: "no turning points at standstill, so the gas force cannot be told";
    ASYMMETRY: "from slow to fast the force grows {ratio} times as much at positive velocity as at negative (known within a factor of {error}); most dampers resist rebound more, so that {verdict}";
    SPEAKS_FOR_REBOUND: "speaks for rebound positive";
    SPEAKS_FOR_COMPRESSION: "speaks for compression positive";
    TELLS_NOTHING: "tells nothing";
    CONTRADICT: "gas force and asymmetry contradict each other; the stronger of the two was followed";
    NOT_DISSIPATING: "no test dissipates energy clearly, so it is not certain that force and motion go together";
    MAYBE_EXCHANGED: "displacement and force look exchanged, so that none of this is sure";
    SIGN_UNSURE: "that the files count {direction} positive is only {percent} % sure: {reasons}. Say it: {option} where that is right, the other direction where it is not";
    NEGATIVE_GAS: "counted so, the gas would pull the rod in with {force} N, which no gas does: either the direction is wrong (--positive), or the load cell has a zero of its own (--force-zero)";
    SIGN_OF_RIG: "{file}: by itself it would be counted {own} positive ({percent} % sure); the surest records of the rig say {other} positive ({sure} %), so it is counted so too. If it comes from another rig, give --positive";
    SIGNS_DISAGREE: "{file}: it counts {own} positive ({percent} % sure), the records that it is compared with count {other} positive ({sure} %); if they come from one rig, one of them is wrong: give --positive";
    WEAK: "the evidence is weak; say which it is with --positive rebound or --positive compression";
    TURNED_ROUND: "turned round in both motion and force, {tests} would go with the other tests, as read not: at like velocities, the force between rebound and compression is {own} N in {test} and {usual} N in the others. Check whether these files count in another direction, and correct the export or leave them out with --exclude";
    OTHER_SETTINGS: "{first} has {times} times the force of {second} in the same motion: these are several dampers, or several settings of one (clicks, current), and one model cannot hold them. Fit them apart (folders, or --exclude). {belong}";
    SEVERAL_SETTINGS: "the tests were measured at {count} settings of {name}, and one model holds one of them: {settings}. Fit them as one damper over {name} with dashpot fit --setting {option}, or each by itself, the others left out with --exclude; dashpot diagnose --group compares them";
    NOT_ONE_DAMPER: "{settings}. To fit all of them as one damper without a setting, give --setting {none}";
    SETTING_AT: "{value}: {names}";
    SETTING_VARIES: "the {setting} of the damper's valve changes between {low} and {high} all through the test";
    SETTING_CHANGES: "{change}. dashpot fit --setting {option} identifies the response of the valve from it; a model at one setting cannot follow it (--exclude)";
    SETTING_STEPS: "the {setting} of the damper's valve steps between {low} and {high} within the test (steps: {count})";
    SETTING_NAME: "the name of {test} states {named}, and its {setting} channel shows {shown}: the channel counts (tests whose name and channel disagree: {count}). Check which is right; to take the names, write their values into campaign.toml under settings";
    SETTING_TYPED: "{text} is no setting: give a number from -{largest} to {largest} with its unit, such as 0.8 A, 12 clicks or 3 bar";
    SETTING_QUANTITY: "{text} is no {setting}; {setting} is the setting of these tests";
    SETTING_QUANTITIES: "these tests have several settings ({names}); correct the setting of a test where only tests of one setting are open";
    SETTINGS: "By their forces these belong together, from soft to hard: {settings}{open}";
    SETTING: "{number}) {names}";
    SETTING_ALL: "all of '{name}' ({count})";
    SETTING_OPEN: "; of {names} the force does not tell it";
    ZERO_OFF: "the force of {tests} lies {low} to {high} N off that of the other tests at like velocities, the same in both directions: the zero of the load cell moved, the gas was warmer, or an adjustable damper had another setting. Set the zero before each test; friction and gas force suffer";
    GIVEN: "{direction} positive was given";
    AGAINST_GIVEN: "{direction} positive was given, but the data speak for the opposite: {reasons}";
    // Parts that a campaign leaves out.
    LEFT_OUT: "left out: {fault}";
    NO_RECORD: "left out, as it is no record: {fault}";
    FIRST_AND_MORE: "{first}; {count} more";
    MORE_LEFT_OUT: "{count|# more file or test was|# more files and tests were} left out";
    // Faults of files.
    UNKNOWN_TYPE: "{file}: is no record; records are {kinds} files";
    NOT_READ: "{file}: is {is}, which is not read; {instead}";
    EMPTY_FILE: "{file}: is empty (0 bytes); export it again";
    WORKBOOK: "{file}: cannot be read as a workbook ({cause}); save it again as .xlsx, or export the sheet as CSV";
    RPC: "{file}: cannot be read as an RPC III time history ({cause})";
    BINARY: "{file}: cannot be read as {kind} ({cause})";
    MAT: "{file}: cannot be read as a MAT file ({cause}); save it again with save(..., '-v7')";
    NO_HEADER: "{at}: no header line found that names time and other channels; the first line reads '{found}'.{near}";
    BEST_LINE: " Best understood is line {line}, with {known}; a heading needs two columns that are understood.";
    TAKEN_FOR: "'{column}' for {channel}";
    FIGURES_ALONE: " It holds {count|# column|# columns} of figures without headings: say all at once which is which, by their numbers, and in which units, as in {options}.";
    NO_DATA: "{at}: has a header but no data rows";
    // Errors of the request.
    NOT_FOUND: "{file}: there is no such file or folder; check the path";
    CANNOT_READ: "{file}: cannot be read ({cause})";
    IS_PEAK_TABLE: "{file}: is a table of peaks and no record over time; dashpot import peaks {file} -o damper.toml makes a model of it";
    NOT_REGULAR: "{file}: is no regular file but a pipe, a device or a folder; save what it gives as a file, and name that";
    TOO_LARGE: "{file}: has {size}, and files of up to {largest} are read; cut it into its tests, or save it with fewer channels or at a lower rate";
    TOO_COSTLY: "{at}: unpacks to more than a file of its size may; save it again as CSV, or cut it into its tests";
    TOO_MANY_COLUMNS: "{at}, line {line}: has {found} columns, more than the {most} that a record may have; save only those that are needed";
    EMPTY_FOLDER: "{folder}: holds no record; a campaign folder holds {kinds}";
    IN_SUBFOLDERS: "{folder}: holds no record itself; {count|# file lies|# files lie} in its subfolders: {names}. Where these are tests of one damper, give --subfolders, which reads them as one campaign; where each is a damper of its own, name one of them, or compare them by dashpot diagnose --group folders";
    KINDS: "{others} and {last}";
    NO_PATHS: "no record given; name a record file or a campaign folder";
    EXCLUDES_NOTHING: "--exclude {pattern} matches no file and no test; the first file is called {first}";
    EXCLUDES_ALL: "--exclude leaves no record; {count|the only file or test matches|all # files and tests match}";
    PROFILES_DISAGREE: "{first} and {second} say different directions positive; make them agree, or give --positive";
    INDISPENSABLE: "{channel} cannot be left out of records; take it off --ignore";
    IN_LINE: "{at}, line {line}: {cause}";
    // Headings and units.
    UNDERSTOOD: "{header} Understood are: {understood}. Other headings can be given as --column force=\"Load Cell 1\"";
    SWAPPED: "{at}: the headings '{first}' and '{second}' look swapped: {evidence}. Correct the header, or give --column {of_first}=\"{second}\" --column {of_second}=\"{first}\" (and --unit where the unit is swapped too); if they are right, give --unit {of_first}=... to insist";
    WRONG_UNIT: "{evidence}; that speaks for {likely} written as {written}. Give --unit {channel}={likely}, or --unit {channel}={written} to insist";
    FILES_UNIT: "{count} of {all} tests {count|does|do} not go with the others, in a way that a unit explains: {tests}. {test} shows ±{force} N at {velocity} mm/s, the others ±{usual} N at {there} mm/s; that speaks for {likely} written as {written}.{either}{labels} Correct the heading of the files that are wrong. Or put them into a folder of their own, say dashpot import-profile FOLDER --unit {channel}={first} once, and name both folders. Or leave them out with --exclude; or give --unit {channel}={written} to insist that all files are in {written}";
    OR_THE_OTHERS: " If these are right, it is the others that are wrong, the other way round: {others}.";
    OR_LABELS: " Where the tests have several settings, wrong labels of some of them can look like that: check these first.";
    LABELS_DEVIATE: "the forces of {count} of {all} tests contradict the other tests at their {name} and agree with those at another one: {groups}. {advice}";
    LABEL_GROUP: "{tests} (label {stated}, forces of {fitting})";
    LABEL_GROUP_OR_UNIT: "{group}, or {likely} written as {written}";
    LABELS_CHECK: "Check the labels of these tests; a corrected value goes into campaign.toml under settings";
    LABELS_MIRRORED: "Each of them has the force of the {name} counted from the other end. Check which end these and the other tests count from; corrected values go into campaign.toml under settings";
    MISSING_COLUMN: "{at}, line {line}: no column for {missing}; the columns are {found}.{near} Name the column with --column {example}=\"heading\"{otherwise}{units}";
    UNITS_TOO: ". Units are missing too: give them as the file has them, as in {options}";
    OR_SAMPLE_RATE: ", or, where the file has none, say --sample-rate 1000 (samples per second)";
    SEVERAL_COLUMNS: "{at}, line {line}: several columns could be {channel}: {names}; choose one with --column {channel}=\"{first}\"";
    NO_SUCH_COLUMN: "{at}, line {line}: there is no column '{wanted}' for {channel}; the columns are {found}.{near}";
    NO_SETTING_COLUMN: "no test has a column '{wanted}' for the setting: check the heading, with --column setting=HEADING or in campaign.toml";
    MEANT: " Is '{near}' meant?";
    MISSING_UNIT: "{at}, line {line}: column '{column}' has no unit; write it in the heading as '{column} [{example}]' or give --unit {channel}={example}. Understood for {channel}: {understood}";
    MISSING_UNITS: "{at}, line {line}: no unit is given for {columns}; say it as the file has it, as in {options}{in_heading}. Understood are: {understood}";
    OR_IN_HEADING: ", or write it in each heading, as in 'Force [N]'";
    UNKNOWN_UNIT: "{at}, line {line}: column '{column}' has the unit '{unit}', which is not understood for {channel}; understood are {understood}. Give --unit {channel}=... if the heading is wrong";
    // Evidence for exchanged headings.
    TIME_STANDS: "the column read as time steps back or stands in {percent} % of the rows, the one read as {other} never does";
    SPANS: "displacement would span {displacement} mm and force {force} N";
    FORCE_SMOOTHER: "{spans}, and the force would be the smoother of the two";
    DERIVATIVE_OF_FORCE: "velocity is the derivative of the column read as force (correlation {with_force}), not of the one read as displacement ({with_displacement})";
    DISPLACEMENT_ROUGHER: "the column read as displacement is {times} times rougher than the one read as force, and the damper would feed energy; {spans}";
    // Evidence for another unit.
    TOO_QUICK: "{record} would move ±{amplitude} mm at {frequency} Hz for {seconds} s";
    TOO_LONG: "{count|the only test|the fastest of # tests} would reach {velocity} mm/s, {count|and last|the longest last} {hours} h, with a sample every {step} s";
    TOO_STIFF: "no test would move more than ±{amplitude} mm, and {force} N at {velocity} mm/s would be a damping of {damping} N s/m";
    MIXED_CURRENT: "{record}: the current of the damper's valve would reach {current} A, and {others} A at most in the other tests; that speaks for mA under a heading of A. Correct the heading of this file, or leave it out with --exclude '{test}'; give --unit current=A to insist";
    TOO_MUCH_CURRENT: "the current of the damper's valve would reach {current} A";
    TOO_WEAK: "{count|the only test|the strongest of # tests} would show ±{strongest} N, and {test} ±{force} N at {velocity} mm/s, a damping of {damping} N s/m";
    // Values that are too large for a damper.
    ABSURD: "{record}: shows {what}, which no suspension damper has; {advice}";
    AN_AMPLITUDE: "an amplitude of {amplitude} m";
    A_VELOCITY: "a peak velocity of {velocity} mm/s";
    A_FORCE: "a force of {force} N";
    SAY_MM: "if the file gives mm, say so: --unit displacement=mm, or velocity=mm/s where it is integrated";
    CHECK_MOTION_UNITS: "check the units of velocity and time: --unit velocity=mm/s, --unit time=s";
    NO_MORE_FORCE: "a force of no more than {force} N";
    SAY_STRONGER: "if the file gives another unit, say it: --unit force=kN";
    UNIT_WAS_GIVEN: "the unit was said, so it is another one, or the column, the gain or the sensor is wrong: check them, and leave --unit out where the heading has the unit";
    SAY_N: "if the file gives N, say so: --unit force=N";
    // All tests of a campaign.
    ALL_WITHOUT_FORCE: "{count} of {all|# test|# tests} {count|shows|show} no force: in {record} it does not stand out of its noise of {noise} N, although the damper moves. Check the load cell and its channel (--column force=\"heading\")";
    FEEDS_ENERGY: "the damper would feed energy into the rig, so a sign is wrong: {cause}";
    FEW_FEED: "{fewer} of {count} tests {fewer|feeds|feed} energy while the other {more|one does|# do} not: {names}. {apart}{also}";
    FEW_TAKE: "{fewer} of {count} tests {fewer|dissipates|dissipate} while the other {more|one does|# do} not: {names}. {apart}{also}";
    APART: "These files count force or motion in another direction than the rest. Load them apart, with --flip force or --flip motion for those that feed energy, or correct the export";
    ALL_FEED: "in {count|the only test|all # tests} with a clear loop force acts along the motion (correlation {correlation}), so force and motion are counted in opposite directions; {culprit}{also}";
    EXCHANGED: "displacement and force look exchanged in {count} of {all|# test|# tests}: {names}. In {test} the column read as force moves like a sine, as a rig does: its overtones are {of_force} % of it. Those of the column read as displacement are {of_displacement} %";
    EXCHANGED_FEED: "{exchanged}; read so, the damper would feed energy into the rig. Give --column displacement=\"heading\" and --column force=\"heading\" the other way round, and --unit where the units go with them. Where only some files have it, put these into a folder of their own, say so there with dashpot import-profile, and name both folders";
    EXCHANGED_DOUBT: "{exchanged}. If so, nothing of what follows is right: give --column displacement=\"heading\" and --column force=\"heading\" the other way round, and leave --flip out";
    OR_LATE: ". Or {late}; then give {option}";
    FLIP_MOTION: "{standstill}; then displacement and velocity are counted positive in compression. Give --flip motion (or correct the export)";
    FLIP_FORCE: "{standstill}; then displacement and velocity are counted positive in rebound. Give --flip force (or correct the export)";
    FLIP_EITHER: "{standstill}. Give --flip force if compression forces are counted positive, --flip motion if compression movements are (or correct the export)";
    // Faults of an imposed motion.
    MOTION_GAP: "{at}, line {line}: {channel} is missing or no number; a motion is used as it stands, so fill the gap or cut it off";
    MOTION_BEYOND: "{at}, line {line}: {channel} is {value}, and a motion stays within ±{limit}; check the unit of the column, which --unit states";
    MOTION_TIME: "{at}, line {line}: time does not increase: {to} s comes after {from} s; a motion needs increasing time";
    SHORT_MOTION: "{at}: has one row; a motion needs at least two";
    SEVERAL_MOTIONS: "{file}: holds several tests, '{first}' and '{second}'; a motion is one, so cut the file";
    // Faults of tests.
    TOO_FEW: "{at}: has only {samples|# usable sample|# usable samples}; a test needs at least {needed}, so measure it again";
    MISSING: "{at}, line {line}: {channel} is missing or not a number here and in {count} of {rows|# row|# rows} in all; too many to drop. Repair the export{advice}";
    OR_IGNORE: ", or leave the channel out with --ignore {channel}";
    TIME_BACKWARDS: "{at}, line {line}: time goes back from {from} s to {to} s. If the file holds several tests one after another, call the column that tells them apart 'test', or split it; otherwise cut the stray block";
    CONSTANT_TIME: "{at}: time does not advance, it is {time} s in every row; check that the right column is read as time";
    FROZEN: "{at}, lines {first} to {last}: {channel} is frozen at {value} {unit} for {seconds} s while {moving}; {advice}";
    CLIPPED: "{at}, first at line {line}: {channel} is clipped at {value} {unit} in {percent} % of the samples, which leaves too little to trust; {advice}";
    NO_MOTION: "{at}: the damper does not move: {channel} shows nothing but noise, within {range} {unit}. Measure the test again, or, if it is meant to stand, take it out";
    CONSTANT_FORCE: "{at}: force is {value} N in every row while the damper moves; check the load cell and its cable, and measure again";
    CELL: "{at}, line {line}, column '{column}': '{text}' is no number{hint}";
    FIELDS: "{at}, line {line}: has {found|# field|# fields} where the header has {expected}{hint}";
    CONTRADICTION: "{at}: displacement and velocity contradict each other: {cause}";
    // Motion of the other channels while a channel is frozen, and advice.
    DAMPER_MOVES: "the damper moves";
    VELOCITY_MOVES: "the velocity says it moves";
    FORCE_CHANGES: "the force changes";
    DISPLACEMENT_CHANGES: "the displacement changes";
    CHECK_CELL: "check the load cell and its cable, and cut these rows or measure again";
    READ_DISPLACEMENT_ONLY: "cut these rows, or read the displacement only: --ignore velocity";
    READ_VELOCITY_ONLY: "cut these rows, or read the velocity only: --ignore displacement";
    CUT_OR_MEASURE: "cut these rows or measure again";
    // Advice about a clipped channel.
    NO_OTHER_MOTION: "there is no other motion channel; measure again with a larger range";
    LARGER_RANGE: "measure again with a larger range of the load cell or its amplifier";
    // Reasons for an invalid cell or row.
    WITHOUT_SEPARATORS: "; write it without thousands separators";
    FORMAT_AS_NUMBERS: "; format the cells as numbers";
    QUOTE_DECIMAL_COMMAS: "; decimal commas need quotes around the cells, or a semicolon or tab between the columns";
    // Contradictions between displacement and velocity.
    VELOCITY_LATE: "'{column}' comes {lag} ms {side} the derivative of the displacement, as that of a filter does; it was not used, and velocity is taken from the displacement";
    BEHIND: "behind";
    AHEAD: "ahead of";
    OTHER_MOTION: "the integral of the velocity explains only {percent} % of the displacement; they do not belong to one motion. Check that the right columns are read (--column velocity=\"heading\"), {advice}";
    OPPOSITE_SIGNS: "they have opposite signs (velocity is {gain} times the derivative of displacement). Turn one of them in the export, {advice}";
    UNIT_SLIP: "velocity is {gain} times the derivative of displacement, a unit slip. Most likely {likely}{others}";
    UNIT_CANDIDATE: "the unit of {channel} is {likely} where {read} was read, for a test of {amplitude} mm at {frequency} Hz and {velocity} mm/s: give {option}";
    OTHERWISE: ". Otherwise {others}";
    OR_ELSE: "; or ";
    OTHER_SCALE: "velocity is {gain} times the derivative of displacement. Check the units and calibration of both, the unit of time, and whether the sampling is fast enough for the motion, {advice}";
    READ_ONE_ONLY: "or read one of them only: --ignore velocity (or --ignore displacement)";
    // Channels.
    CHANNEL_TIME: "time";
    CHANNEL_DISPLACEMENT: "displacement";
    CHANNEL_VELOCITY: "velocity";
    CHANNEL_FORCE: "force";
    CHANNEL_SIDE_FORCE: "side_force";
    CHANNEL_TEMPERATURE: "temperature";
    CHANNEL_CURRENT: "current";
    CHANNEL_SETTING: "setting";
    // Files in formats that are not read, and what to do.
    FAMOS: "an imc FAMOS file";
    OLD_WORKBOOK: "a workbook of Excel 97 to 2003 (.xls), or a document of that time";
    OPEN_DOCUMENT: "an OpenDocument file";
    DIADEM_HEADING: "the heading of a DIAdem data set, whose numbers lie in other files";
    DIADEM: "a DIAdem data set";
    HDF5: "an HDF5 file";
    DATABASE: "a database";
    ZIP: "a zip archive";
    GZIP: "a packed file (gzip)";
    PDF: "a PDF";
    XML: "an XML file";
    CATMAN: "a binary file of catman";
    EXPORT_FROM_IMC: "export it from imc FAMOS or imc STUDIO as CSV, MDF 4 or TDMS";
    SAVE_AS_XLSX: "save it as .xlsx";
    SAVE_AS_TDMS: "save it in DIAdem as TDMS";
    SAVE_CHANNELS: "save its channels as CSV or as a MAT file";
    EXPORT_AS_CSV: "export the test as CSV";
    UNPACK_FOLDER: "unpack it, and name the folder";
    UNPACK: "unpack it";
    EXPORT_FROM_CATMAN: "export it from catman as ASCII, MDF 4 or MAT";
}
