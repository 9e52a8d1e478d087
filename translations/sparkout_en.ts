<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en_US">
    <context>
        <name>BatchText</name>
        <message numerus="yes">
            <source>%n part(s), %1.</source>
            <translation>
                <numerusform>%n part, %1.</numerusform>
                <numerusform>%n parts, %1.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n did not reach size.</source>
            <translation>
                <numerusform>%n did not reach size.</numerusform>
                <numerusform>%n did not reach size.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::FormPage</name>
        <message numerus="yes">
            <source>%1 · %n other(s) shown</source>
            <translation>
                <numerusform>%1 · %n other shown</numerusform>
                <numerusform>%1 · %n others shown</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>FileQuestion</name>
        <message numerus="yes">
            <source>%n more</source>
            <translation>
                <numerusform>%n more</numerusform>
                <numerusform>%n more</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>“%1” has %n other names (hard links). They will keep the old text and no longer be the same file.</source>
            <translation>
                <numerusform>“%1” has %n other name (hard link). It will keep the old text and no longer be the same file.</numerusform>
                <numerusform>“%1” has %n other names (hard links). They will keep the old text and no longer be the same file.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>OperationSetup</name>
        <message numerus="yes">
            <source>%n gap(s), %1 % of the turn is ground</source>
            <translation>
                <numerusform>%n gap, %1 % of the turn is ground</numerusform>
                <numerusform>%n gaps, %1 % of the turn is ground</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>PassportPrediction</name>
        <message numerus="yes">
            <source>Of the %n part(s) number %1 has the minimum margin. %2.</source>
            <translation>
                <numerusform>Of the %n part number %1 has the minimum margin. %2.</numerusform>
                <numerusform>Of the %n parts number %1 has the minimum margin. %2.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>PassportInputs</name>
        <message numerus="yes">
            <source>as measured, %n value(s), %1</source>
            <translation>
                <numerusform>as measured, %n value, %1</numerusform>
                <numerusform>as measured, %n values, %1</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1, %n part(s) between settings of the gauge</source>
            <translation>
                <numerusform>%1, %n part between settings of the gauge</numerusform>
                <numerusform>%1, %n parts between settings of the gauge</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1, %n part(s) between dressings</source>
            <translation>
                <numerusform>%1, %n part between dressings</numerusform>
                <numerusform>%1, %n parts between dressings</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Minimum and maximum tried: of the first %n parts.</source>
            <translation>
                <numerusform>Minimum and maximum tried: of the first part.</numerusform>
                <numerusform>Minimum and maximum tried: of the first %n parts.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>ProfileCsv</name>
        <message numerus="yes">
            <source>it holds %n values; needed: an even number, %1</source>
            <translation>
                <numerusform>it holds %n value; needed: an even number, %1</numerusform>
                <numerusform>it holds %n values; needed: an even number, %1</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::CatalogueDialog</name>
        <message numerus="yes">
            <source>%n inputs change (in bold); the others stay as they are.</source>
            <translation>
                <numerusform>%n input changes (in bold); the others stay as they are.</numerusform>
                <numerusform>%n inputs change (in bold); the others stay as they are.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::CompareView</name>
        <message numerus="yes">
            <source>; and %n more</source>
            <translation>
                <numerusform>; and %n more</numerusform>
                <numerusform>; and %n more</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::FactorBox</name>
        <message numerus="yes">
            <source>%n values, %1…%2 %3</source>
            <translation>
                <numerusform>%n value, %1…%2 %3</numerusform>
                <numerusform>%n values, %1…%2 %3</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::MessagesDock</name>
        <message numerus="yes">
            <source>%n message(s)</source>
            <translation>
                <numerusform>%n message</numerusform>
                <numerusform>%n messages</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::MainWindow</name>
        <message numerus="yes">
            <source>Saved. %n fields contain invalid entries; their last valid values were saved.</source>
            <translation>
                <numerusform>Saved. %n field contains an invalid entry; its last valid value was saved.</numerusform>
                <numerusform>Saved. %n fields contain invalid entries; their last valid values were saved.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::StatusLine</name>
        <message numerus="yes">
            <source>Not computed: %n faults in the inputs. The curves show the last good run.</source>
            <translation>
                <numerusform>Not computed: %n fault in the inputs. The curves show the last good run.</numerusform>
                <numerusform>Not computed: %n faults in the inputs. The curves show the last good run.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Not computed: %n faults in the inputs.</source>
            <translation>
                <numerusform>Not computed: %n fault in the inputs.</numerusform>
                <numerusform>Not computed: %n faults in the inputs.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::NumbersEditor</name>
        <message numerus="yes">
            <source>%n number(s) separated by semicolons</source>
            <translation>
                <numerusform>%n number</numerusform>
                <numerusform>%n numbers separated by semicolons</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>BatchCharts</name>
        <message numerus="yes">
            <source>%1: %n part(s), %2 % of the batch</source>
            <translation>
                <numerusform>%1: %n part, %2 % of the batch</numerusform>
                <numerusform>%1: %n parts, %2 % of the batch</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1: %2 %3, %n part(s)</source>
            <translation>
                <numerusform>%1: %2 %3, %n part</numerusform>
                <numerusform>%1: %2 %3, %n parts</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::RadiiEditor</name>
        <message numerus="yes">
            <source>%n values, %1…%2 %3</source>
            <translation>
                <numerusform>%n value, %1…%2 %3</numerusform>
                <numerusform>%n values, %1…%2 %3</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::RecoveryDialog</name>
        <message numerus="yes">
            <source>Recovery files are kept in %1; discarded ones stay in %2 for %n days.</source>
            <translation>
                <numerusform>Recovery files are kept in %1; discarded ones stay in %2 for %n day.</numerusform>
                <numerusform>Recovery files are kept in %1; discarded ones stay in %2 for %n days.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::RowsEditor</name>
        <message numerus="yes">
            <source>rows of %n number(s) separated by semicolons, as in 0 50; 200 80</source>
            <translation>
                <numerusform>rows of one number separated by semicolons, as in 50; 80</numerusform>
                <numerusform>rows of %n numbers separated by semicolons, as in 0 50; 200 80</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::RunKeeper</name>
        <message numerus="yes">
            <source>%n kept runs give other results with this version of the program: %1.</source>
            <translation>
                <numerusform>A kept run gives other results with this version of the program: %1.</numerusform>
                <numerusform>%n kept runs give other results with this version of the program: %1.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::StageCountPlot</name>
        <message numerus="yes">
            <source>%n stage(s)</source>
            <translation>
                <numerusform>%n stage</numerusform>
                <numerusform>%n stages</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::StageModel</name>
        <message numerus="yes">
            <source>%n double strokes</source>
            <translation>
                <numerusform>%n dbl stroke</numerusform>
                <numerusform>%n dbl strokes</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n revolutions</source>
            <translation>
                <numerusform>%n revolution</numerusform>
                <numerusform>%n revolutions</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::VerdictPanel</name>
        <message numerus="yes">
            <source>%n fields contain invalid entries; the verdict is based on their last valid values.</source>
            <translation>
                <numerusform>%n field contains an invalid entry; the verdict is based on its last valid value.</numerusform>
                <numerusform>%n fields contain invalid entries; the verdict is based on their last valid values.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>OverviewCharts</name>
        <message numerus="yes">
            <source>%n ranges of the machine are met and not drawn.</source>
            <translation>
                <numerusform>%n range of the machine is met and not drawn.</numerusform>
                <numerusform>%n ranges of the machine are met and not drawn.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>ListPaste</name>
        <message numerus="yes">
            <source>%n column(s) too many from the selected cell on</source>
            <translation>
                <numerusform>%n column too many from the selected cell on</numerusform>
                <numerusform>%n columns too many from the selected cell on</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::ListTable</name>
        <message numerus="yes">
            <source>Not pasted: %n further cell(s)</source>
            <translation>
                <numerusform>Not pasted: %n further cell</numerusform>
                <numerusform>Not pasted: %n further cells</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n further remark(s) among the messages</source>
            <translation>
                <numerusform>%n further remark among the messages</numerusform>
                <numerusform>%n further remarks among the messages</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::NumberLines</name>
        <message numerus="yes">
            <source>%n cell(s) too many</source>
            <translation>
                <numerusform>%n cell too many</numerusform>
                <numerusform>%n cells too many</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::ExamplesDialog</name>
        <message numerus="yes">
            <source>%n surfaces in one set-up</source>
            <translation>
                <numerusform>%n surface in one set-up</numerusform>
                <numerusform>%n surfaces in one set-up</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>FitWords</name>
        <message numerus="yes">
            <source>%n measured part(s)</source>
            <translation>
                <numerusform>%n measured part</numerusform>
                <numerusform>%n measured parts</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::FitResult</name>
        <message numerus="yes">
            <source>Found from %n measured value(s).</source>
            <translation>
                <numerusform>Found from %n measured value.</numerusform>
                <numerusform>Found from %n measured values.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::WheelPage</name>
        <message numerus="yes">
            <source>measured Ra of %n part(s)</source>
            <translation>
                <numerusform>measured Ra of %n part</numerusform>
                <numerusform>measured Ra of %n parts</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>MeasuredText</name>
        <message numerus="yes">
            <source>and %n more</source>
            <translation>
                <numerusform>and %n more</numerusform>
                <numerusform>and %n more</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>PassportMeasured</name>
        <message numerus="yes">
            <source>Mean with Student&apos;s interval of 95 %; predicted: the range that contains 95 % of %n part(s) of the batch; F: the ratio of the variance of the measured parts to the predicted one, with the limits that it stays within by chance; inside: measured parts within the predicted range.</source>
            <translation>
                <numerusform>Mean with Student&apos;s interval of 95 %; predicted: the range that contains 95 % of %n part of the batch; F: the ratio of the variance of the measured parts to the predicted one, with the limits that it stays within by chance; inside: measured parts within the predicted range.</numerusform>
                <numerusform>Mean with Student&apos;s interval of 95 %; predicted: the range that contains 95 % of %n parts of the batch; F: the ratio of the variance of the measured parts to the predicted one, with the limits that it stays within by chance; inside: measured parts within the predicted range.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::ImportDialog</name>
        <message numerus="yes">
            <source>%n part(s)</source>
            <translation>
                <numerusform>%n part</numerusform>
                <numerusform>%n parts</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n row(s) of zones or sections that the project does not have</source>
            <translation>
                <numerusform>%n row of zones or sections that the project does not have</numerusform>
                <numerusform>%n rows of zones or sections that the project does not have</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n line(s) read</source>
            <translation>
                <numerusform>%n line read</numerusform>
                <numerusform>%n lines read</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n cell(s) are refused:</source>
            <translation>
                <numerusform>%n cell is refused:</numerusform>
                <numerusform>%n cells are refused:</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::MeasuredView</name>
        <message numerus="yes">
            <source>The prediction is of a batch of %n part(s).</source>
            <translation>
                <numerusform>The prediction is of a batch of %n part.</numerusform>
                <numerusform>The prediction is of a batch of %n parts.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>StateGridText</name>
        <message numerus="yes">
            <source>takes %1 in %n stage(s)</source>
            <translation>
                <numerusform>takes %1 in %n stage</numerusform>
                <numerusform>takes %1 in %n stages</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>The rule fails in %n state(s), first in %1: %2.</source>
            <translation>
                <numerusform>The rule fails in %n state, first in %1: %2.</numerusform>
                <numerusform>The rule fails in %n states, first in %1: %2.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::StiffnessPage</name>
        <message numerus="yes">
            <source>stiffness trial at %n place(s)</source>
            <translation>
                <numerusform>stiffness trial at %n place</numerusform>
                <numerusform>stiffness trial at %n places</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n reading(s); those less what the stiffness gives: RMS %1 µm.</source>
            <translation>
                <numerusform>%n reading; less what the stiffness gives: RMS %1 µm.</numerusform>
                <numerusform>%n readings; those less what the stiffness gives: RMS %1 µm.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>sparkout::TrialPage</name>
        <message numerus="yes">
            <source>then %n double stroke(s) of spark-out</source>
            <translation>
                <numerusform>then %n double stroke of spark-out</numerusform>
                <numerusform>then %n double strokes of spark-out</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>then %n revolution(s) of spark-out</source>
            <translation>
                <numerusform>then %n revolution of spark-out</numerusform>
                <numerusform>then %n revolutions of spark-out</numerusform>
            </translation>
        </message>
    </context>
</TS>
