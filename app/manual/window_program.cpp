// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/command_line.h"

namespace sparkout::manual {

namespace {

std::vector<Option> windowOptions() {
    return {
        {.name = "--picture",
         .value = file("OUT.png"),
         .group = "output",
         .text =
             {"writes a picture of the window with FILE and its result, without showing the window",
              "записывает снимок окна с файлом FILE и его результатом, ничего не показывая"}},
        {.name = "--report",
         .value = textLike("KIND", "a kind of report",
                           "card passport handout operation-card sketch-sheet lab-report worksheet "
                           "worksheet-key guide"),
         .needs = "-o -d",
         .group = "output",
         .text =
             {"writes a report of FILE, shows nothing: card is the cycle card; passport the "
              "accuracy passport, with the batch; handout the hand-out of a course, a step of the "
              "cycle worked out; operation-card the operation card in the form of the standard and "
              "its sketch sheet, with every surface of the set-up; sketch-sheet the sketch sheet "
              "alone; lab-report the report on a laboratory work, of a student's work "
              "(.sparkout-work); worksheet a step of the cycle and the tasks of a lesson with "
              "places for the answers, of a lesson (.sparkout-lesson), a work or a project; "
              "worksheet-key its answers, of a lesson or a project; guide the teacher's teaching "
              "guide, of a lesson",
              "записывает отчёт по файлу FILE, ничего не показывая: card — карта цикла; passport — "
              "паспорт точности с партией; handout — раздаточный материал с разбором шага; "
              "operation-card — операционная карта с картой эскизов, со всеми поверхностями "
              "установа; sketch-sheet — только карта эскизов; lab-report — отчёт по лабораторной "
              "работе из файла студента (.sparkout-work); worksheet — рабочий лист: шаг цикла и "
              "задания с местом для ответов, по работе преподавателя (.sparkout-lesson), работе "
              "студента или проекту; worksheet-key — ответы к нему, по работе преподавателя или "
              "проекту; guide — методические указания, по работе преподавателя"}},
        {.name = "--export",
         .value = textLike(
             "PART", "a part of the results",
             "all inputs cycle stages zones profiles requirements trace batch sweep search"),
         .needs = "-o",
         .group = "output",
         .text = {"writes results of FILE as tables, shows nothing: all, inputs, cycle, stages, "
                  "zones, profiles, requirements or trace; batch, sweep and search run that of the "
                  "project first",
                  "записывает результаты файла FILE таблицами, ничего не показывая: all — все, "
                  "inputs — исходные данные, cycle — цикл, stages — ступени, zones — зоны, "
                  "profiles — профили, requirements — требования, trace — трасса; batch, sweep и "
                  "search сначала рассчитывают партию, варьирование или поиск проекта"}},
        {.name = "-o",
         .value = file("OUT"),
         .needs = "--report --export",
         .group = "place",
         .text =
             {"the file of the report or the tables; its ending determines the format: .pdf, "
              ".html, .md (Markdown) or .odt; .xlsx, .csv (one table; with --lang ru semicolons "
              "and decimal commas, as Russian Excel has them) or .json (all: the object of "
              "sparkout-cli simulate --json)",
              "файл отчёта или таблиц; вид задаёт расширение: .pdf, .html, .md (Markdown) или "
              ".odt; .xlsx, .csv (одна таблица; с --lang ru точки с запятой и десятичные запятые, "
              "как в русском Excel) или .json (all: объект команды sparkout-cli simulate --json)"}},
        {.name = "-d",
         .value = folder("DIR"),
         .needs = "--report",
         .group = "place",
         .text = {"the folder of many reports, each with the name of its FILE; progress goes to "
                  "stderr, a file that is refused does not stop the others",
                  "папка отчётов по нескольким файлам, каждый с именем своего файла FILE; ход "
                  "печатается в stderr, отклонённый файл не останавливает остальных"}},
        {.name = "--format",
         .value = choice("pdf html md odt", "FORMAT"),
         .needs = "-d",
         .text = {"their format: pdf, html, md or odt; pdf unless given",
                  "их формат: pdf, html, md или odt; по умолчанию pdf"}},
        {.name = "--force",
         .needs = "-d",
         .text = {"existing files may be replaced", "заменять существующие файлы"}},
        {.name = "--surface",
         .value = textLike("NAME|N", "a name or a number from 1"),
         .needs = "--picture --report --export",
         .text = {"the surface of a file of several, by its name or its number from 1; without it "
                  "operation card and sketch have all, the other reports need it",
                  "поверхность файла нескольких поверхностей, по имени или по номеру (с 1); без "
                  "неё операционная карта и эскиз содержат все, остальным отчётам она нужна"}},
        {.name = "--at",
         .value = textLike("STEP", "a step, as 12,nz,z1,e1,r1,k9"),
         .needs = "--report",
         .text = {"the step that a hand-out or the worksheet of a project works out: double stroke "
                  "(plunge: revolution), zone or section, stage, step, its revolution and radius, "
                  "as far as wanted, as in 12,nz,z1,e1,r1,k9; of several matching steps the one "
                  "with the deepest cut; z1 unless given",
                  "шаг, который разбирает раздаточный материал или рабочий лист проекта: двойной "
                  "ход (врезное: оборот), зона или сечение, ступень, этап, его оборот и радиус, "
                  "сколько нужно, например 12,nz,z1,e1,r1,k9; из подходящих — с наибольшей "
                  "глубиной; по умолчанию z1"}},
        {.name = "--views",
         .value = Value{Kind::anything, "VIEWS",
                        "feeds, cycle, profiles, limits, grid, with commas between"},
         .needs = "--report",
         .text = {"figures of a hand-out: feeds, cycle, profiles, limits, grid, with commas "
                  "between; feeds,cycle,profiles unless given; none of them: \"\"; of a lab-report "
                  "cycle and profiles",
                  "рисунки раздаточного материала: feeds, cycle, profiles, limits, grid через "
                  "запятую; по умолчанию feeds,cycle,profiles; без рисунков: \"\"; для lab-report "
                  "— cycle и profiles"}},
        {.name = "--answers",
         .value = choice("on off"),
         .needs = "--report",
         .text = {"whether a hand-out has the answers to its questions, on unless given",
                  "давать ли в раздаточном материале ответы на вопросы; по умолчанию on"}},
        {.name = "--lang",
         .value = choice("en ru"),
         .text = {"language of the window, the report or the tables, this time only",
                  "язык окна, отчёта или таблиц, только на этот раз"}},
        {.name = "--theme",
         .value = choice("system light dark contrast", "THEME"),
         .text = {"system, light, dark or contrast, this time only",
                  "оформление: system, light, dark или contrast, только на этот раз"}},
        {.name = "--font-size",
         .value = choice("90 100 115 130", "N"),
         .text =
             {"size of type in per cent of the system's: 90, 100, 115 or 130, this time only",
              "размер шрифта в процентах от системного: 90, 100, 115 или 130, только на этот раз"}},
        {.name = "--view",
         .value = textLike("VIEW", "a view, by name or number",
                           "overview feeds profiles constraints compliance layers batch sweep "
                           "optimise compare measured"),
         .text = {"the view to show, by name (feeds) or number",
                  "открытый вид, по имени (feeds) или по номеру"}},
        {.name = "--stroke",
         .value = integer("N", 0, highestInteger),
         .text = {"the cycle after N double strokes or revolutions, at its end unless given",
                  "цикл после N двойных ходов или оборотов; по умолчанию — в конце"}},
        {.name = "--size",
         .value = textLike("WxH", "WIDTHxHEIGHT, 400x300 to 10000x10000"),
         .text = {"size of the window, 1366x768 unless given",
                  "размер окна; по умолчанию 1366x768"}},
        {.name = "--portable",
         .text = {"keeps settings, own catalogues and recovery in the folder settings beside the "
                  "program, as on a stick, without changing those of the user",
                  "хранит настройки, свои каталоги и данные восстановления в папке settings рядом "
                  "с программой, например на флешке, и не трогает настройки пользователя"}},
        {.name = "--time-start",
         .text = {"opens the window, prints a line when it was painted for the first time and "
                  "closes it, to measure the start-up time",
                  "открывает окно, печатает строку, когда оно впервые нарисовано, и закрывает его "
                  "— для измерения времени запуска"}},
        {.name = "--version", .text = {"prints the version", "печатает версию"}},
    };
}

} // namespace

const Program& windowProgram() {
    static const Program program{
        {"sparkout",
         {"FILE", Kind::project, "a file", 0, anyNumber},
         {"workbench for cylindrical grinding cycles", "расчёт циклов круглого шлифования"},
         windowOptions()},
        {"[--portable] [FILE]",
         "--picture OUT.png [--lang en|ru] [--theme THEME] [--view VIEW] [--font-size N] [--stroke "
         "N] [--size WxH] [--surface NAME|N] FILE",
         "--report KIND -o OUT.pdf|OUT.html|OUT.md|OUT.odt [--lang en|ru] [--at STEP] [--views "
         "VIEWS] [--answers on|off] [--surface NAME|N] FILE",
         "--report KIND -d DIR [--format pdf|html|md|odt] [--force] [--lang en|ru] FILE…",
         "--export PART -o OUT.xlsx|OUT.csv|OUT.json [--lang en|ru] [--surface NAME|N] FILE"},
        {"Opens the workbench, with FILE or with an example. It computes a cylindrical grinding "
         "cycle pass by pass and compares the part with its drawing. The help of the window "
         "describes the rest.",
         "Открывает окно с файлом FILE или с примером. Программа рассчитывает цикл круглого "
         "шлифования по проходам и сравнивает деталь с чертежом. Остальное — в справке окна."},
        {{"sparkout-cli needs no display.", "Без экрана работает sparkout-cli."},
         {"The program uses no network: it looks for no updates and sends nothing.",
          "Программа не обращается к сети: не ищет обновлений и ничего не отправляет."}},
        {{"0", {"done", "выполнено"}},
         {"1",
          {"the file is refused or the output cannot be written",
           "файл не принят или результат нельзя записать"}},
         {"2", {"wrong usage or no display", "неверный вызов или нет экрана"}},
         {"3",
          {"the cycle cannot reach size (report or tables are written)",
           "цикл не выходит на размер (отчёт или таблицы записаны)"}},
         {"5",
          {"no cycle of the search is feasible (nothing is written)",
           "подходящего цикла в сетке нет (ничего не записано)"}},
         {"6",
          {"the search found no cycle for all scenarios, but a fit one may exist (nothing is "
           "written)",
           "поиск не нашёл цикла для всех сценариев, но он может существовать (ничего не "
           "записано)"}},
         {"130",
          {"ended by Ctrl+C (nothing is written). With -d it is the first status that is not 0, "
           "and written files remain",
           "прервано Ctrl+C (ничего не записано). С -d — первый код файлов, отличный от 0; "
           "записанное остаётся"}}}};
    return program;
}

} // namespace sparkout::manual
