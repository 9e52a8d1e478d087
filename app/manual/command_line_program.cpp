// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/command_line.h"

namespace sparkout::manual {

namespace {

constexpr Operands oneFile{"FILE", Kind::project, "a file", 1, 1};
constexpr Option json{.name = "--json",
                      .group = "output",
                      .text = {"prints one JSON object", "печатает один объект JSON"}};
constexpr Option surface{
    .name = "--surface",
    .value = textLike("NAME|N|all", "a name, a number from 1 or all"),
    .text = {
        "the surface of a file of several, by its name or its number from 1, or all",
        "поверхность файла нескольких поверхностей, по имени или по номеру (с 1), или all — все"}};
constexpr Option threads{
    .name = "--threads",
    .value = integer("N", 1, 1024),
    .text = {"number of threads, by default one per processor; the answer is the same",
             "число потоков вместо одного на процессор; ответ тот же"}};
constexpr Option progress{.name = "--progress",
                          .text = {"prints progress to stderr, even when that is not a terminal",
                                   "печатает ход расчёта в stderr, даже если это не терминал"}};

Option csv(Text text) {
    return {.name = "--csv", .group = "output", .text = text};
}

Option check(Text text) {
    return {.name = "--check", .text = text};
}

Command simulateCommand() {
    return {"simulate",
            oneFile,
            {"runs the cycle of a project file", "рассчитывает цикл файла проекта"},
            {surface,
             json,
             check({"exit status 4 when a requirement is not met",
                    "код завершения 4, если требование нарушено"}),
             {.name = "--batch",
              .text = {"runs the batch of the project, too, and judges the cycle for it and by the "
                       "measured parts of the project, if there are any",
                       "рассчитывает и партию проекта и говорит, годен ли цикл для неё и по "
                       "измеренным деталям проекта, если они есть"}},
             {.name = "--trace",
              .value = file("OUT.csv"),
              .text = {"writes a row for every visit of a radius",
                       "пишет строку на каждое прохождение радиуса под кругом"}}}};
}

Command remediesCommand() {
    return {"remedies",
            oneFile,
            {"finds up to three changes of one setting, or a starting cycle, with which an unfit "
             "cycle meets all requirements or a cycle close to a limit gains a sufficient margin: "
             "each is the middle of an interval of values that were run, for every stock and the "
             "batch, and the one that costs least comes first; where none of the values tried "
             "helps, states the reason and the requirements that are not met",
             "находит изменения одной настройки или исходный цикл, при которых выполнены все "
             "требования нарушавшего их цикла либо у цикла, близкого к пределу, появляется запас: "
             "до трёх, каждое — середина интервала рассчитанных значений, для всех припусков и для "
             "партии, сначала наименее затратное; если при проверенных значениях не помогает ни "
             "одно — почему, с нарушенными требованиями"},
            {surface, json}};
}

Command optimizeCommand() {
    return {
        "optimize",
        oneFile,
        {"finds the quickest cycle of the file's grid that meets every requirement",
         "находит самый быстрый цикл сетки файла, при котором выполнены все требования"},
        {surface,
         {.name = "--robust",
          .text = {"the cycle must be fit for every stock within half an infeed of the stated one: "
                   "under gauge control this is decided, under position control it is tried on 500 "
                   "stocks drawn at random, with the confidence stated; a file whose optimisation "
                   "has the scenarios corners or batch is searched for those without this option",
                   "цикл должен быть годен для всех припусков в пределах подачи на шаг: при "
                   "управлении от прибора это решается точно, при управлении по положению "
                   "проверяется на 500 случайных припусках с указанием доверительной вероятности; "
                   "файл, в котором для поиска заданы сценарии corners или batch, рассчитывается "
                   "для них и без этого параметра"}},
         {.name = "--refine",
          .text = {"continues from the best cycle of the grid between its levels, in the machine's "
                   "steps: a quicker fit cycle, if one is found; it is not proved",
                   "ищет дальше от лучшего цикла сетки, между её уровнями, шагами станка: более "
                   "быстрый годный цикл, если встретится; он не доказан"}},
         {.name = "--front",
          .text = {"also finds the best cycle of each number of stages, and slower cycles farther "
                   "from their limits: time against margin",
                   "кроме ответа лучший цикл для каждого числа ступеней и более медленные циклы, "
                   "которые дальше от пределов: запас против времени"}},
         {.name = "--method",
          .value = choice("search full dp labels"),
          .text = {"search: proves the answer from few runs; full: runs every cycle; for plunge "
                   "grinding also two heuristics, which prove nothing and may find no cycle where "
                   "there is one: dp, the dynamic programming that was published, and labels, "
                   "which keeps more ways to each stock level",
                   "search: доказывает ответ немногими расчётами; full: рассчитывает все циклы; "
                   "для врезного шлифования ещё две эвристики, которые ничего не доказывают и "
                   "могут не найти существующего цикла: dp — опубликованное динамическое "
                   "программирование, labels — больше путей к каждому уровню припуска"}},
         {.name = "--stages",
          .value = integers("N,…", 1, 5),
          .text = {"numbers of stages to try, instead of the file's",
                   "проверяемые числа ступеней вместо заданных в файле"}},
         {.name = "--time-limit",
          .value = number("S", "a number of seconds", 0, 1e9),
          .text =
              {"ends search, refinement and front after this number of seconds, as Ctrl+C does: "
               "the best cycle so far is kept, with a bound below which no cycle lies",
               "прекращает поиск, уточнение и запасы по времени через столько секунд, как Ctrl+C: "
               "остаётся лучшее из найденного и время, быстрее которого цикла нет"}},
         {.name = "--threads",
          .value = integer("N", 1, 1024),
          .text = {"number of threads of the full search, by default one per processor; the answer "
                   "is the same",
                   "число потоков полного поиска вместо одного на процессор; ответ тот же"}},
         {.name = "--resume",
          .value = file("FILE"),
          .text = {"keeps the progress of the full search in this file, every second and at a "
                   "stop; the same command with the same file continues where it was stopped or "
                   "killed, and gives the same answer",
                   "для полного поиска: сохраняет его ход в этом файле каждую секунду и при "
                   "остановке; та же команда с тем же файлом продолжает с места, где поиск "
                   "остановили или прервали, и даёт тот же ответ"}},
         json,
         {.name = "-o",
          .value = projectFile("OUT.sparkout"),
          .text = {"writes the project with the cycle found",
                   "записывает проект с найденным циклом"}}}};
}

Command validateCommand() {
    return {"validate",
            oneFile,
            {"checks a project file and prints one line for each fault",
             "проверяет файл проекта: по строке на ошибку"},
            {}};
}

std::vector<Option> batchOptions() {
    return {
        surface,
        {.name = "--parts",
         .value = integer("N", 1, 1'000'000),
         .text = {"number of parts, instead of the file's",
                  "число деталей вместо заданного в файле"}},
        {.name = "--seed",
         .value = integer("S", 0, highestInteger),
         .text = {"seed, instead of the file's", "номер выборки вместо заданного в файле"}},
        {.name = "--scenarios",
         .value = choice("corners latin_hypercube sobol random", "HOW"),
         .text = {"corners, latin_hypercube, sobol or random, instead of the file's",
                  "способ выборки вместо заданного в файле: corners, latin_hypercube, sobol или "
                  "random"}},
        {.name = "--measured",
         .value = file("BLANKS.csv"),
         .text = {"CSV whose columns are headed by factors (stock_mm, initial_runout_mm, …): their "
                  "values replace the file's laws",
                  "CSV со столбцами факторов (stock_mm, initial_runout_mm, …): их значения вместо "
                  "законов распределения файла"}},
        {.name = "--until-width",
         .value = number("W", "a width in µm", aboveZero, 1e9),
         .text = {"ends as soon as every 95 % interval of a mean is W µm wide at most",
                  "заканчивает, когда каждый интервал 95 % среднего не шире W мкм"}},
        {.name = "--sensitivity",
         .value = integer("N", 1, 65'536),
         .text = {"Sobol indices, from N·(factors + 2) parts more",
                  "индексы Соболя, ещё по N·(факторов + 2) деталям"}},
        threads,
        {.name = "--rows",
         .value = file("OUT.csv"),
         .text =
             {"writes a row for every part: its factors, all quantities, and whether each "
              "requirement is met; the file is the same for any number of threads, and is not "
              "written after Ctrl+C",
              "пишет строку на деталь: её факторы, все показатели, выполнено ли каждое требование; "
              "одинаково при любом числе потоков; если прервано Ctrl+C, файла нет"}},
        {.name = "--force",
         .needs = "--rows",
         .text = {"--rows may replace a file", "--rows может заменить существующий файл"}},
        json,
        csv({"prints a row for every characteristic", "печатает строку на каждую характеристику"}),
        {.name = "--shard",
         .value = textLike("I/N", "I/N, I from 1 to N"),
         .group = "output",
         .text = {"runs the I-th of N shards and prints it for batch-merge",
                  "рассчитывает I-ю из N частей и печатает её для batch-merge"}},
        check({"exit status 4 when a part is rejected",
               "код завершения 4, если требование нарушено у какой-либо детали"}),
        progress};
}

Command batchCommand() {
    return {"batch",
            oneFile,
            {"runs the batch of a project file: its parts differ by the factors given there. "
             "Ctrl+C ends it; the parts done until then are evaluated and printed",
             "рассчитывает партию файла проекта: детали отличаются заданными в нём факторами. "
             "Ctrl+C прерывает расчёт, сделанное оценивается и печатается"},
            batchOptions()};
}

Command mergeCommand() {
    return {
        "batch-merge",
        {"SHARD…", Kind::file, "a file", 1, anyNumber},
        {"joins the shards of a batch: the answer is that of one run; a changed, missing, doubled "
         "or foreign shard is named and refused. For a cluster with Slurm there is batch.sbatch",
         "соединяет части партии: ответ тот же, что у одного расчёта; изменённая, недостающая, "
         "повторная или чужая часть называется и отклоняется. Для кластера со Slurm есть "
         "batch.sbatch"},
        {json,
         csv({"prints a row for every characteristic", "печатает строку на каждую характеристику"}),
         check({"exit status 4 when a part is rejected",
                "код завершения 4, если требование нарушено у какой-либо детали"})}};
}

Command sweepCommand() {
    return {"sweep",
            oneFile,
            {"runs the sweep of a project file: one or two inputs varied over their ranges",
             "рассчитывает варьирование файла проекта: одна или две величины меняются в своих "
             "диапазонах"},
            {surface, threads, json,
             csv({"prints a row for every point", "печатает строку на каждую точку"}), progress}};
}

Command phasesCommand() {
    return {"phases",
            oneFile,
            {"decides for which stocks of the blank the cycle meets every requirement, under gauge "
             "control: the position of the last step of a stage changes with the stock, and the "
             "size with it. Every stock of the range is decided, none is sampled",
             "решает, при каких припусках заготовки цикл выдерживает все требования при управлении "
             "от прибора: от припуска зависит, куда придётся последний шаг ступени, а от него "
             "размер. Решено о каждом припуске диапазона, выборки нет"},
            {surface,
             {.name = "--from",
              .value = number("MM", "a stock per side in mm", aboveZero, 1e3),
              .text = {"minimum stock per side in mm, instead of the file's less half the maximum "
                       "infeed of a stage",
                       "наименьший припуск на сторону в мм вместо припуска файла за вычетом "
                       "половины наибольшей подачи на шаг"}},
             {.name = "--to",
              .value = number("MM", "a stock per side in mm", aboveZero, 1e3),
              .text = {"maximum stock per side in mm, instead of the file's plus half the maximum "
                       "infeed of a stage",
                       "наибольший припуск на сторону в мм вместо припуска файла с прибавлением "
                       "половины наибольшей подачи на шаг"}},
             json,
             check({"exit status 4 when the cycle is unfit for a stock",
                    "код завершения 4, если цикл не годен хотя бы при одном припуске"})}};
}

Command dressingCommand() {
    return {"dressing",
            oneFile,
            {"runs part after part with the wheel as left by the parts before, by the wear in the "
             "file, until the first part that is not good: the parts between two dressings. With "
             "the rates of optimisation/cost also the number of parts after which dressing is "
             "quickest and cheapest",
             "рассчитывает деталь за деталью с кругом, каким его оставили предыдущие по износу из "
             "файла, до первой негодной: число деталей между двумя правками. Если задана "
             "optimisation/cost, также через сколько деталей правка выгоднее всего по времени и по "
             "стоимости"},
            {{.name = "--scenarios",
              .value = choice("corners latin_hypercube sobol random", "HOW"),
              .text = {"the cycle must also be fit for the parts of the surface's batch, chosen by "
                       "corners, latin_hypercube, sobol or random",
                       "каждая деталь должна быть годна и для деталей партии поверхности, "
                       "выбранных как corners, latin_hypercube, sobol или random"}},
             json,
             check({"exit status 4 when no part is good",
                    "код завершения 4, если не годна ни одна деталь"}),
             progress}};
}

Command wavesCommand() {
    return {
        "waves",
        oneFile,
        {"names what can have left the waves that were counted around a part: the wheel, by the "
         "speeds of the file, known frequencies, the wheel head's natural one, or what is "
         "fixed to the work; with the counts at another work speed and another wheel speed, "
         "by which they are told apart",
         "называет, от чего могли появиться волны, сосчитанные вокруг детали: от круга (по "
         "скоростям из файла), от известных частот, от собственной частоты шлифовальной "
         "бабки или от того, что связано с деталью; и сколько волн будет при другой частоте "
         "вращения заготовки и другой частоте вращения круга: по этому их различают"},
        {surface,
         {.name = "--count",
          .value = integer("N", 4, 100'000),
          .isRequired = true,
          .text = {"number of waves counted around the part",
                   "число волн, сосчитанных вокруг детали"}},
         {.name = "--frequencies",
          .value = numbers("HZ,…", "frequencies in Hz", 0.1, 100'000),
          .text = {"known frequencies in Hz: motors, belts, pumps, the floor",
                   "известные частоты в Гц: двигатели, ремни, насосы, пол"}},
         json}};
}

std::vector<Option> measuredOptions() {
    return {
        surface,
        {.name = "--data",
         .value = file("TABLE.csv"),
         .text = {"reads a table of parts or traces, too: a CSV file in either dialect whose "
                  "headings name quantities and units (\"Diameter, mm\", \"Диаметр, мм\", \"t, "
                  "s\", \"P [kW]\"), or lines time|key|value",
                  "читает ещё и таблицу деталей или записей: CSV любого диалекта, заголовки "
                  "которого называют величины и единицы («Diameter, mm», «Диаметр, мм», «t, s», «P "
                  "[kW]»), или строки time|key|value"}},
        {.name = "--fit",
         .value = textLike("PARAMETER,…", "parameters, as alpha,beta,size_offset"),
         .text =
             {"finds parameters from the traces and diameters: alpha, beta, compliance (of all, or "
              "compliance:N of one zone or section), flow_stress, dullness, chip_power, "
              "friction_power, idle_power, size_offset, time_shift, power_delay, force_delay, "
              "blank_runout, gauge_lag, power_lag, force_lag, gauge_drift, of finished parts "
              "gauge_setting; beta=1.2~0.1 states the mean and the standard deviation known "
              "before; names undetermined "
              "parameters and what to measure; exit status 4 when the model does not fit, or a "
              "time, lag or drift that it needs is left out",
              "находит параметры по записям и диаметрам: alpha, beta, compliance (всех мест или "
              "compliance:N одной зоны или сечения), flow_stress, dullness, chip_power, "
              "friction_power, idle_power, size_offset, time_shift, power_delay, force_delay, "
              "blank_runout, gauge_lag, power_lag, force_lag, gauge_drift, по готовым деталям "
              "gauge_setting; "
              "beta=1.2~0.1 — с тем, что известно заранее: среднее и его стандартное отклонение; "
              "называет то, чего по данным определить нельзя, и что измерить; код завершения 4, "
              "если модель не подходит, не учтён нужный ей сдвиг, запаздывание или дрейф или "
              "значение лежит вне обычного диапазона"}},
        {.name = "--loss",
         .value = choice("none huber tukey"),
         .needs = "--fit",
         .text = {"loss of --fit: outliers weigh less (huber) or hardly count (tukey)",
                  "для --fit: выбросы весят меньше (huber) или почти не учитываются (tukey)"}},
        {.name = "-o",
         .value = projectFile("OUT.sparkout"),
         .needs = "--fit",
         .text = {"saves the project with the inputs that --fit has found, each with the data of "
                  "its calibration; saves nothing if no usable values were found",
                  "сохраняет проект с исходными данными, найденными --fit, и с тем, по чему каждое "
                  "откалибровано; ничего, если пригодных значений не найдено"}},
        {.name = "--roundness",
         .text = {"states instead the form of each zone or section after the cycle as a roundness "
                  "machine does, about the four reference circles, not filtered and after the "
                  "Gaussian filter of ISO 16610-21 at 15, 50 and 150 undulations per revolution",
                  "вместо этого: форма каждой зоны или сечения после цикла, как её указывает "
                  "кругломер, относительно четырёх базовых окружностей, без фильтра и после "
                  "фильтра Гаусса по ISO 16610-21 с границей 15, 50 и 150 волн на оборот"}},
        {.name = "--profile",
         .value = file("TABLE.csv"),
         .text = {"also states the form of a recorded section: a table of angle [°] and radius "
                  "[mm], or of deviations if the heading names µm",
                  "то же для записанного сечения: таблица угла [°] и радиуса [мм] или отклонений, "
                  "если в заголовке указаны мкм"}},
        {.name = "--trial",
         .value = textLike("PARAMETER,…", "parameters, as alpha,beta"),
         .text = {"finds instead which of 24 short trials determines these parameters best, by "
                  "feed, spark-out and recorded quantities, with the 95 % intervals to expect",
                  "вместо этого: какой из 24 коротких опытов лучше определяет эти параметры, по "
                  "подаче, выхаживанию и записываемым величинам, с ожидаемыми интервалами 95 %"}},
        {.name = "--stiffness-sheet",
         .text = {"prints instead the steps, places and load of a stiffness trial",
                  "вместо этого: порядок, места и нагрузка опыта на жёсткость"}},
        {.name = "--stiffness",
         .value = file("TABLE.csv"),
         .text = {"computes instead the stiffness of headstock and tailstock from a table of place "
                  "[mm], load [N] and deflection [µm]",
                  "вместо этого: жёсткость передней и задней бабки по таблице мест [мм], нагрузок "
                  "[Н] и отжатий [мкм]"}},
        {.name = "--indicator",
         .value = choice("part system"),
         .needs = "--stiffness --stiffness-sheet",
         .text = {"part: the indicator shows the part against the bed; system: against the wheel "
                  "head, whose stiffness follows from three places; with two it is the file's",
                  "part: индикатор показывает деталь относительно станины; system: относительно "
                  "шлифовальной бабки, жёсткость которой дают три места, при двух она берётся из "
                  "файла"}},
        json,
        check({"exit status 4 when the model disagrees with the parts, or the data leave a "
               "parameter undetermined",
               "код завершения 4, если модель не согласуется с деталями или данные не определяют "
               "параметр"}),
        progress};
}

Command measuredCommand() {
    return {"measured",
            oneFile,
            {"compares the measurements in the file's section measured with the predicted batch: "
             "for each zone or section and quantity the mean with its 95 % interval, the predicted "
             "range, Fisher's ratio of the variances, the share of the parts inside",
             "сравнивает измеренное (раздел файла measured) с партией, которую прогнозирует "
             "модель: для каждой зоны или сечения и каждой величины — среднее с интервалом 95 %, "
             "диапазон прогноза, отношение дисперсий Фишера, доля деталей в этом диапазоне"},
            measuredOptions()};
}

Command courseCommand() {
    const Command check{
        "course check",
        {"FILE", Kind::file, "a file", 1, 1},
        {"states the faults of a lesson and what each step finds in its project as given; the "
         "seals and answers of a student's work (.sparkout-work); the kept runs of a project",
         "показывает ошибки занятия и то, что каждый шаг находит в его проекте; печати и ответы "
         "работы студента (.sparkout-work); запомненные расчёты проекта"},
        {json}};
    const Command variants{
        "course variants",
        {"LESSON", Kind::file, "a lesson", 1, 1},
        {"writes a work for each student of a list, valid, not solved as given, with a proved best "
         "cycle near to the lesson's in time and margin, no two alike; beside them stand "
         "assignments.csv to hand out and teacher-best-answers.csv to keep",
         "записывает работу каждому студенту списка: допустимую, не решённую сразу, с доказанным "
         "лучшим циклом, близким к циклу занятия по времени и запасу, без повторов, и рядом "
         "assignments.csv для раздачи и teacher-best-answers.csv для преподавателя"},
        {{.name = "--group",
          .value = file("LIST.csv"),
          .isRequired = true,
          .text = {"the students, a table of names and groups",
                   "студенты, таблица с именами и группами"}},
         {.name = "--seed",
          .value = integer("S", 0, highestInteger),
          .isRequired = true,
          .text = {"the same seed gives the same variants",
                   "один и тот же номер выборки даёт одни и те же варианты"}},
         {.name = "-d",
          .value = folder("DIR"),
          .isRequired = true,
          .text = {"the folder for the works", "папка для работ"}},
         {.name = "--force",
          .text = {"existing works are replaced", "имеющиеся работы заменяются"}}}};
    const Command grade{
        "course grade",
        {"LESSON DIR", Kind::file, "a lesson and a folder of works", 2, 2},
        {"marks the works of a folder, every answer computed again from the lesson; edited, "
         "foreign and copied works are named",
         "проверяет работы папки, каждый ответ рассчитан заново по занятию; изменённые, чужие и "
         "списанные работы названы"},
        {{.name = "--group",
          .value = file("LIST.csv"),
          .text = {"the students: those whose works are missing are named",
                   "студенты: те, чьих работ нет, названы"}},
         {.name = "--answers",
          .value = file("TABLE.csv"),
          .text = {"the table of best answers; without it they are searched for",
                   "таблица лучших ответов; без неё они отыскиваются"}},
         json,
         csv({"prints a row for every work", "печатает строку на каждую работу"}),
         {.name = "--xlsx",
          .needs = "-o",
          .group = "output",
          .text = {"writes a workbook with a row for every work, and the steps on a second sheet",
                   "записывает книгу XLSX со строкой на каждую работу и с шагами на втором листе"}},
         {.name = "-o",
          .value = file("OUT.xlsx"),
          .needs = "--xlsx",
          .text = {"the workbook that --xlsx writes", "книга, которую записывает --xlsx"}},
         {.name = "--force",
          .needs = "--xlsx",
          .text = {"an existing workbook is replaced", "имеющаяся книга заменяется"}}}};
    return {"course",
            {},
            {"laboratory works for a class; a lesson is a file .sparkout-lesson",
             "лабораторные работы для группы; занятие — файл .sparkout-lesson"},
            {},
            {check, variants, grade}};
}

Command newCommand() {
    return {
        "new",
        {"SIZE", Kind::anything, "a size with its field, as 35k6", 1, 1},
        {"writes a project with a starting cycle for a surface of a drawing, given by its size "
         "with the field, as 35k6 or for a bore 60H7, and the options below. Work speed, feeds, "
         "stocks and spark-out follow from diameter, stock, tolerance, material, wheel and "
         "machine, in steps of the machine; the limit of the rough depth, the times of the stages "
         "and the stocks for which the cycle is fit are printed; the project has a typical search "
         "about it. A part or a wheel that the machine does not take is refused",
         "записывает проект с исходным циклом для поверхности чертежа: размер с полем, например "
         "35k6, для отверстия 60H7, и то, что о нём сказано ниже. Частота вращения заготовки, "
         "подачи, припуски и выхаживание следуют из диаметра, припуска, допуска, материала, круга "
         "и станка, с шагом станка; печатается, что ограничивает черновую глубину резания, время "
         "ступеней и при каких припусках цикл годен; в проекте есть обычный поиск около него. "
         "Деталь и круг, которые станок не принимает, отклоняются"},
        {{.name = "--length",
          .value = number("MM", "a length in mm", 0.1, 1e4),
          .isRequired = true,
          .text = {"ground length in mm", "длина шлифования в мм"}},
         {.name = "--stock",
          .value = number("MM", "a stock per side in mm", 0.01, 5),
          .isRequired = true,
          .text = {"minimum stock per side in mm", "наименьший припуск на сторону в мм"}},
         {.name = "--bore",
          .text = {"a bore, also where the field is written in small letters",
                   "отверстие, даже если поле записано строчными буквами"}},
         {.name = "--operation",
          .value = choice("plunge traverse"),
          .text = {"kind of operation; by default plunge grinding if the wheel covers the length, "
                   "otherwise traverse grinding",
                   "вместо врезного шлифования, если круг перекрывает длину, иначе с продольной "
                   "подачей"}},
         {.name = "--shoulder",
          .value = choice("headstock tailstock both"),
          .text = {"an end that the wheel cannot run over; a plain cylinder has none",
                   "конец, за который круг выйти не может; у гладкого цилиндра таких нет"}},
         {.name = "--ra",
          .value = number("UM", "Ra in µm", aboveZero, 1e2),
          .text = {"required Ra in µm", "требуемая Ra в мкм"}},
         {.name = "--machine",
          .value = textLike("NAME", "a name of the catalogue"),
          .text = {"of the catalogue, instead of 3М151, for a bore 3К227; part of a name will do",
                   "станок каталога вместо 3М151, для отверстия 3К227; достаточно части названия"}},
         {.name = "--wheel",
          .value = textLike("NAME", "a name of the catalogue"),
          .text = {"a wheel of the catalogue, instead of the one that suits machine, length, "
                   "material and Ra, for a bore the widest that fits into it",
                   "круг каталога вместо подходящего станку, длине, материалу и Ra, для отверстия "
                   "— самого большого, входящего в него"}},
         {.name = "--material",
          .value = textLike("NAME", "a name of the catalogue"),
          .text = {"of the catalogue, instead of hardened 40Х",
                   "материал каталога вместо закалённой стали 40Х"}},
         {.name = "-o",
          .value = file("OUT.sparkout"),
          .isRequired = true,
          .text = {"the project", "файл проекта"}},
         {.name = "--force", .text = {"replaces an existing file", "заменяет имеющийся файл"}}}};
}

Command examplesCommand() {
    return {
        "examples",
        {"DIR", Kind::folder, "a folder", 1, 1},
        {"writes the example projects into a folder, which is created if needed; if one of them "
         "was edited there, nothing is written",
         "записывает проекты-примеры в папку, создавая её при необходимости; если какой-либо из "
         "них там изменён, ничего не записывается"},
        {{.name = "--force", .text = {"replaces edited examples", "заменяет изменённые"}}}};
}

} // namespace

const Program& commandLineProgram() {
    static const Program program{
        {"sparkout-cli",
         {},
         {"cylindrical grinding cycles, computed pass by pass",
          "расчёт циклов круглого шлифования по проходам"},
         {{.name = "--version", .text = {"prints the version", "печатает версию"}}},
         {newCommand(), simulateCommand(), remediesCommand(), optimizeCommand(), validateCommand(),
          batchCommand(), mergeCommand(), sweepCommand(), phasesCommand(), dressingCommand(),
          wavesCommand(), measuredCommand(), examplesCommand(), courseCommand()}},
        {},
        {"Computes without a window: for scripts, long batches and computers without a display. It "
         "reads the project files of the window and gives the same numbers, digit for digit.",
         "Считает без окна: для скриптов, больших партий и компьютеров без экрана. Читает файлы "
         "проектов окна и даёт те же числа, до последнего знака."},
        {{"A file may hold several surfaces of a part that are ground in one set-up. simulate, "
          "remedies, optimize, batch, sweep, phases, waves and measured take each in its order, or "
          "the one that --surface names, with the wheel as the surfaces before left it. A time "
          "limit "
          "applies to each surface.",
          "Файл может содержать несколько поверхностей детали, шлифуемых за один установ. "
          "simulate, remedies, optimize, batch, sweep, phases, waves и measured берут их все по "
          "порядку "
          "или ту, что названа в --surface; круг приходит к ней таким, каким его оставили "
          "предыдущие. Предел времени действует для каждой поверхности."},
         {"In JSON and CSV the sections of a plunge and the parts of a batch are counted from 0, "
          "as in the file; in texts, in the window and in its reports from 1.",
          "В JSON и CSV сечения при врезном шлифовании и детали партии считаются с 0, как в файле; "
          "в текстах, в окне и его отчётах — с 1."},
         {"A batch on a cluster, here with Slurm: batch.sbatch, beside the examples of the "
          "installation and in resources/help of the source.",
          "Партия на кластере со Slurm: batch.sbatch, рядом с примерами установленной программы и "
          "в resources/help исходного кода."}},
        {{"0", {"done", "выполнено"}},
         {"1", {"the input is refused", "исходные данные не приняты"}},
         {"2", {"wrong usage", "неверный вызов"}},
         {"3", {"the cycle cannot reach size", "цикл не выходит на размер"}},
         {"4", {"a requirement is not met (--check)", "требование нарушено (--check)"}},
         {"5", {"no cycle of the grid is feasible", "подходящего цикла в сетке нет"}},
         {"6",
          {"optimize found no cycle, but a fit one may exist: its time was up, or the method "
           "proves nothing",
           "optimize не нашёл цикла, но он может существовать: истекло время или метод ничего не "
           "доказывает"}},
         {"130, 143",
          {"ended by Ctrl+C or SIGTERM; optimize with a cycle found ends with 0 and prints it",
           "прервано Ctrl+C или SIGTERM до конца; optimize с найденным циклом завершается с кодом "
           "0 и выдаёт его"}}}};
    return program;
}

} // namespace sparkout::manual
