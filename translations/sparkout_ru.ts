<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en_US">
    <context>
        <name>BatchFigures</name>
        <message>
            <source>Median</source>
            <translation>Медиана</translation>
        </message>
        <message>
            <source>Percentile %1 %</source>
            <translation>Квантиль %1 %</translation>
        </message>
        <message>
            <source>%1 % of the parts lie below this value, as below mean − 3 s of a normal quantity; given for 741 parts or more</source>
            <translation>Ниже него %1 % деталей, как ниже среднего − 3 s у нормальной величины; указывается от 741 детали</translation>
        </message>
        <message>
            <source>%1 % of the parts lie above this value, as above mean + 3 s of a normal quantity; given for 741 parts or more</source>
            <translation>Выше него %1 % деталей, как выше среднего + 3 s у нормальной величины; указывается от 741 детали</translation>
        </message>
        <message>
            <source>Where</source>
            <translation>Где</translation>
        </message>
        <message>
            <source>Characteristic</source>
            <translation>Характеристика</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Normality, test</source>
            <translation>Нормальность, критерий</translation>
        </message>
    </context>
    <context>
        <name>BatchText</name>
        <message>
            <source>Machining time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>Mean diameter</source>
            <translation>Средний диаметр</translation>
        </message>
        <message>
            <source>whole part</source>
            <translation>вся деталь</translation>
        </message>
        <message>
            <source>%1 (%2 %)</source>
            <translation>%1 (%2 %)</translation>
        </message>
        <message>
            <source>%1 (%2 %; %3…%4 %)</source>
            <translation>%1 (%2 %; %3…%4 %)</translation>
        </message>
        <message>
            <source>%1, not normal</source>
            <translation>%1, не норм.</translation>
        </message>
        <message>
            <source>Only the nominal part was run: no factor scatters.</source>
            <translation>Только номинальная деталь: ничего не рассеивается.</translation>
        </message>
        <message numerus="yes">
            <source>%n part(s), %1.</source>
            <translation>
                <numerusform>%n деталь, %1.</numerusform>
                <numerusform>%n детали, %1.</numerusform>
                <numerusform>%n деталей, %1.</numerusform>
            </translation>
        </message>
        <message>
            <source>%1, seed %2</source>
            <comment>Latin hypercube, seed 1</comment>
            <translation>%1, номер выборки %2</translation>
        </message>
        <message>
            <source>Stopped after %1 of %2 parts, %3.</source>
            <translation>Остановлено после %1 из %2 деталей, %3.</translation>
        </message>
        <message>
            <source>Rejected: %1.</source>
            <translation>Не годны: %1.</translation>
        </message>
        <message>
            <source>Not counted: %1.</source>
            <translation>Не учтено: %1.</translation>
        </message>
        <message>
            <source>%1 of %2 parts have no size, form and Ra: strips stay uncut, so no Ppk is given.</source>
            <translation>У %1 из %2 деталей нет размера, формы и Ra: остаются непрошлифованные полосы, поэтому Ppk не указан.</translation>
        </message>
        <message numerus="yes">
            <source>%n did not reach size.</source>
            <translation>
                <numerusform>%n не вышла на размер.</numerusform>
                <numerusform>%n не вышли на размер.</numerusform>
                <numerusform>%n не вышли на размер.</numerusform>
            </translation>
        </message>
        <message>
            <source>%1 of %2 parts</source>
            <translation>%1 из %2 деталей</translation>
        </message>
        <message>
            <source>Part %1</source>
            <translation>Деталь %1</translation>
        </message>
        <message>
            <source>Shapiro–Wilk</source>
            <translation>Шапиро — Уилка</translation>
        </message>
        <message>
            <source>Anderson–Darling</source>
            <translation>Андерсона — Дарлинга</translation>
        </message>
        <message>
            <source>Normality, p</source>
            <translation>Нормальность, p</translation>
        </message>
        <message>
            <source>Normality, p (%1)</source>
            <comment>name of the test</comment>
            <translation>Нормальность, p (критерий %1)</translation>
        </message>
        <message>
            <source>%1, p</source>
            <comment>name of the test</comment>
            <translation>p (%1)</translation>
        </message>
        <message>
            <source>is fit</source>
            <translation>годен</translation>
        </message>
        <message>
            <source>is conditionally fit</source>
            <translation>условно годен</translation>
        </message>
        <message>
            <source>is unfit</source>
            <translation>не годен</translation>
        </message>
        <message>
            <source>no part was run</source>
            <translation>ни одна деталь не рассчитана</translation>
        </message>
        <message>
            <source>%1 % of the parts are rejected, more than the allowed %2 %</source>
            <translation>негодных деталей %1 %, больше допустимых %2 %</translation>
        </message>
        <message>
            <source>not every part is good</source>
            <translation>не все детали годны</translation>
        </message>
        <message>
            <source>%1 % of the parts are rejected, no more than the allowed %2 %</source>
            <translation>негодных деталей %1 %, не больше допустимых %2 %</translation>
        </message>
        <message>
            <source>not all parts of the batch were run</source>
            <translation>рассчитаны не все детали партии</translation>
        </message>
        <message>
            <source>every part that was run is good, but corner parts are not a sample, so Ppk is not known</source>
            <translation>все рассчитанные детали годны, но крайние сочетания — не выборка, и Ppk по ним не определить</translation>
        </message>
        <message>
            <source>Ppk cannot be computed from one part</source>
            <translation>по одной детали Ppk не определить</translation>
        </message>
        <message>
            <source>%1 % of the parts are expected out of tolerance, more than the allowed %2 %: %3</source>
            <translation>ожидаемая доля вне допуска %1 %, больше допустимых %2 %: %3</translation>
        </message>
        <message>
            <source>Ppk %1, its lower bound below %2: %3</source>
            <translation>Ppk %1, нижняя граница меньше %2: %3</translation>
        </message>
        <message>
            <source>every part is good, and the lower bound of Ppk is at least %1 everywhere; lowest Ppk %2, %3</source>
            <translation>все детали годны, нижняя граница Ppk везде не меньше %1; наименьший Ppk %2, %3</translation>
        </message>
        <message>
            <source>every part is good, and the sizes hardly scatter</source>
            <translation>все детали годны, размеры почти не рассеиваются</translation>
        </message>
        <message>
            <source>The cycle %1: %2.</source>
            <comment>verdict, reason</comment>
            <translation>Цикл %1: %2.</translation>
        </message>
        <message>
            <source>Not decided: %1.</source>
            <translation>Не определено: %1.</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Диаметр</translation>
        </message>
    </context>
    <context>
        <name>CardForm</name>
        <message>
            <source>Copy</source>
            <translation>Дубл.</translation>
        </message>
        <message>
            <source>Repl.</source>
            <translation>Взам.</translation>
        </message>
        <message>
            <source>Orig.</source>
            <translation>Подл.</translation>
        </message>
        <message>
            <source>Rev.</source>
            <translation>Изм.</translation>
        </message>
        <message>
            <source>Sheet</source>
            <translation>Лист</translation>
        </message>
        <message>
            <source>Doc. no.</source>
            <translation>№ докум.</translation>
        </message>
        <message>
            <source>Sign.</source>
            <translation>Подпись</translation>
        </message>
        <message>
            <source>Date</source>
            <translation>Дата</translation>
        </message>
        <message>
            <source>Sheets</source>
            <translation>Листов</translation>
        </message>
        <message>
            <source>Prepared</source>
            <translation>Разраб.</translation>
        </message>
        <message>
            <source>Checked</source>
            <translation>Пров.</translation>
        </message>
        <message>
            <source>Agreed</source>
            <translation>Согл.</translation>
        </message>
        <message>
            <source>Standards</source>
            <translation>Н. контр.</translation>
        </message>
        <message>
            <source>Approved</source>
            <translation>Утв.</translation>
        </message>
        <message>
            <source>Company, department</source>
            <translation>Предприятие, подразделение</translation>
        </message>
        <message>
            <source>Part designation</source>
            <translation>Обозначение изделия</translation>
        </message>
        <message>
            <source>Document number</source>
            <translation>Обозначение документа</translation>
        </message>
        <message>
            <source>Name of the part</source>
            <translation>Наименование изделия</translation>
        </message>
        <message>
            <source>Letter</source>
            <translation>Литера</translation>
        </message>
        <message>
            <source>Shop</source>
            <translation>Цех</translation>
        </message>
        <message>
            <source>Area</source>
            <translation>Уч.</translation>
        </message>
        <message>
            <source>Workpl.</source>
            <translation>РМ</translation>
        </message>
        <message>
            <source>Oper.</source>
            <translation>Опер.</translation>
        </message>
        <message>
            <source>Name of the operation</source>
            <translation>Наименование операции</translation>
        </message>
        <message>
            <source>Material</source>
            <translation>Материал</translation>
        </message>
        <message>
            <source>Hardness</source>
            <translation>Твёрдость</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>ЕВ</translation>
        </message>
        <message>
            <source>Part mass</source>
            <translation>МД</translation>
        </message>
        <message>
            <source>Profile and sizes</source>
            <translation>Профиль и размеры</translation>
        </message>
        <message>
            <source>Raw mass</source>
            <translation>МЗ</translation>
        </message>
        <message>
            <source>At once</source>
            <translation>КОИД</translation>
        </message>
        <message>
            <source>Equipment, NC control</source>
            <translation>Оборудование, устройство ЧПУ</translation>
        </message>
        <message>
            <source>NC program number</source>
            <translation>Обозначение программы</translation>
        </message>
        <message>
            <source>Main, min</source>
            <translation>То, мин</translation>
        </message>
        <message>
            <source>Auxil., min</source>
            <translation>Тв, мин</translation>
        </message>
        <message>
            <source>Setting, min</source>
            <translation>Тпз, мин</translation>
        </message>
        <message>
            <source>Piece, min</source>
            <translation>Тшт, мин</translation>
        </message>
        <message>
            <source>Coolant</source>
            <translation>СОЖ</translation>
        </message>
        <message>
            <source>R</source>
            <translation>Р</translation>
        </message>
        <message>
            <source>Step, settings</source>
            <translation>Содержание перехода, режим</translation>
        </message>
        <message>
            <source>Pos.</source>
            <translation>ПИ</translation>
        </message>
        <message>
            <source>D or B, mm</source>
            <translation>D или B, мм</translation>
        </message>
        <message>
            <source>L, mm</source>
            <translation>L, мм</translation>
        </message>
        <message>
            <source>t, mm</source>
            <translation>t, мм</translation>
        </message>
        <message>
            <source>i</source>
            <translation>i</translation>
        </message>
        <message>
            <source>S</source>
            <translation>S</translation>
        </message>
        <message>
            <source>n, rev/min</source>
            <translation>n, об/мин</translation>
        </message>
        <message>
            <source>V, m/min</source>
            <translation>V, м/мин</translation>
        </message>
        <message>
            <source>OC</source>
            <translation>ОК</translation>
        </message>
        <message>
            <source>Operation card, machining</source>
            <translation>Операционная карта механической обработки</translation>
        </message>
        <message>
            <source>after GOST 3.1404-86, form 2</source>
            <translation>по образцу ГОСТ 3.1404-86, форма 2</translation>
        </message>
        <message>
            <source>after GOST 3.1404-86, form 2a</source>
            <translation>по образцу ГОСТ 3.1404-86, форма 2а</translation>
        </message>
        <message>
            <source>The form is modelled on GOST 3.1404-86 and 3.1103: check it against the current edition. The numbers are predictions of a model, to be confirmed at the machine.</source>
            <translation>Форма составлена по образцу ГОСТ 3.1404-86 и ГОСТ 3.1103, сверьте с действующей редакцией. Числа предсказаны моделью и подлежат проверке на станке.</translation>
        </message>
        <message>
            <source>SK</source>
            <translation>КЭ</translation>
        </message>
        <message>
            <source>Sketch sheet</source>
            <translation>Карта эскизов</translation>
        </message>
        <message>
            <source>after GOST 3.1105-84, form 7</source>
            <translation>по образцу ГОСТ 3.1105-84, форма 7</translation>
        </message>
        <message>
            <source>after GOST 3.1105-84, form 7a</source>
            <translation>по образцу ГОСТ 3.1105-84, форма 7а</translation>
        </message>
        <message>
            <source>The form is modelled on GOST 3.1105-84 and 3.1103: check it against the current edition. Not to scale.</source>
            <translation>Форма составлена по образцу ГОСТ 3.1105-84 и ГОСТ 3.1103, сверьте с действующей редакцией. Эскиз не в масштабе.</translation>
        </message>
        <message>
            <source>d MMM yy</source>
            <translation>dd.MM.yy</translation>
        </message>
    </context>
    <context>
        <name>Catalogue</name>
        <message>
            <source>not given</source>
            <translation>не задано</translation>
        </message>
        <message>
            <source>own value</source>
            <translation>своё значение</translation>
        </message>
        <message>
            <source>estimate, to be calibrated</source>
            <translation>оценка, подлежит калибровке</translation>
        </message>
        <message>
            <source>own values</source>
            <translation>свои значения</translation>
        </message>
        <message>
            <source>estimates</source>
            <translation>оценки</translation>
        </message>
        <message>
            <source>not known</source>
            <translation>неизвестно</translation>
        </message>
    </context>
    <context>
        <name>Choice</name>
        <message>
            <source>until size</source>
            <translation>до размера</translation>
        </message>
        <message>
            <source>nominal part</source>
            <translation>номинальной детали</translation>
        </message>
        <message>
            <source>every stock</source>
            <translation>все припуски</translation>
        </message>
        <message>
            <source>all corners</source>
            <translation>всех крайних сочетаний</translation>
        </message>
        <message>
            <source>the batch</source>
            <translation>партии</translation>
        </message>
        <message>
            <source>traverse grinding</source>
            <translation>с продольной подачей</translation>
        </message>
        <message>
            <source>plunge grinding</source>
            <translation>врезное</translation>
        </message>
        <message>
            <source>headstock</source>
            <translation>у передней бабки</translation>
        </message>
        <message>
            <source>at the entry</source>
            <translation>у входа</translation>
        </message>
        <message>
            <source>at the exit</source>
            <translation>у выхода</translation>
        </message>
        <message>
            <source>half at each</source>
            <translation>пополам</translation>
        </message>
        <message>
            <source>constant peripheral speed</source>
            <translation>скорость постоянна</translation>
        </message>
        <message>
            <source>constant revolutions</source>
            <translation>обороты постоянны</translation>
        </message>
        <message>
            <source>tailstock</source>
            <translation>у задней бабки</translation>
        </message>
        <message>
            <source>by the in-process gauge</source>
            <translation>от прибора (ПАК)</translation>
        </message>
        <message>
            <source>by wheel head position</source>
            <translation>по положению бабки</translation>
        </message>
        <message>
            <source>minimum diameter</source>
            <translation>наименьший диаметр</translation>
        </message>
        <message>
            <source>mean diameter</source>
            <translation>средний диаметр</translation>
        </message>
        <message>
            <source>maximum diameter</source>
            <translation>наибольший диаметр</translation>
        </message>
        <message>
            <source>external (shaft)</source>
            <translation>наружная</translation>
        </message>
        <message>
            <source>internal (bore)</source>
            <translation>внутренняя</translation>
        </message>
        <message>
            <source>ellipse</source>
            <translation>овальность</translation>
        </message>
        <message>
            <source>eccentric circle</source>
            <translation>эксцентриситет</translation>
        </message>
        <message>
            <source>lobed</source>
            <translation>огранка</translation>
        </message>
        <message>
            <source>measured</source>
            <translation>измеренная</translation>
        </message>
        <message>
            <source>between centres</source>
            <translation>в центрах</translation>
        </message>
        <message>
            <source>in a chuck</source>
            <translation>в патроне</translation>
        </message>
        <message>
            <source>Latin hypercube</source>
            <translation>латинский гиперкуб</translation>
        </message>
        <message>
            <source>Sobol sequence</source>
            <translation>последовательность Соболя</translation>
        </message>
        <message>
            <source>random</source>
            <translation>случайная выборка</translation>
        </message>
        <message>
            <source>completed</source>
            <translation>завершён</translation>
        </message>
        <message>
            <source>cannot reach size</source>
            <translation>размер не достигается</translation>
        </message>
        <message>
            <source>too long</source>
            <translation>слишком долгий</translation>
        </message>
        <message>
            <source>stopped</source>
            <translation>остановлено</translation>
        </message>
        <message>
            <source>balance not solved</source>
            <translation>равновесие не найдено</translation>
        </message>
        <message>
            <source>equal steps</source>
            <translation>равные шаги</translation>
        </message>
        <message>
            <source>equal ratios</source>
            <translation>равные отношения</translation>
        </message>
        <message>
            <source>ground away</source>
            <translation>деталь сошлифована</translation>
        </message>
        <message>
            <source>diameter deviation</source>
            <translation>отклонение диаметра</translation>
        </message>
        <message>
            <source>radial runout</source>
            <translation>радиальное биение</translation>
        </message>
        <message>
            <source>roundness</source>
            <translation>отклонение от круглости</translation>
        </message>
        <message>
            <source>cylindricity</source>
            <translation>отклонение от цилиндричности</translation>
        </message>
        <message>
            <source>roughness Ra</source>
            <translation>шероховатость Ra</translation>
        </message>
        <message>
            <source>size at the gauge</source>
            <translation>размер по прибору</translation>
        </message>
        <message>
            <source>wheel power</source>
            <translation>мощность привода круга</translation>
        </message>
        <message>
            <source>spindle current</source>
            <translation>ток шпинделя</translation>
        </message>
        <message>
            <source>normal force</source>
            <translation>нормальная сила</translation>
        </message>
        <message>
            <source>minimum time</source>
            <translation>наименьшее время</translation>
        </message>
        <message>
            <source>minimum cost</source>
            <translation>наименьшая стоимость</translation>
        </message>
        <message>
            <source>most parts per dressing</source>
            <translation>больше всего деталей на правку</translation>
        </message>
        <message>
            <source>shown, not changed</source>
            <translation>видны, не изменяются</translation>
        </message>
        <message>
            <source>changed by the student</source>
            <translation>изменяет студент</translation>
        </message>
        <message>
            <source>not shown</source>
            <translation>не видны</translation>
        </message>
        <message>
            <source>double strokes or revolutions</source>
            <translation>двойных ходов или оборотов</translation>
        </message>
        <message>
            <source>stages</source>
            <translation>ступеней</translation>
        </message>
        <message>
            <source>zones or sections</source>
            <translation>зон или сечений</translation>
        </message>
        <message>
            <source>the whole double stroke</source>
            <translation>весь двойной ход</translation>
        </message>
        <message>
            <source>Overview</source>
            <translation>Обзор</translation>
        </message>
        <message>
            <source>Feeds by stage</source>
            <translation>Подачи по ступеням</translation>
        </message>
        <message>
            <source>Profiles</source>
            <translation>Профили</translation>
        </message>
        <message>
            <source>Constraints</source>
            <translation>Ограничения</translation>
        </message>
        <message>
            <source>Compliance</source>
            <translation>Податливость</translation>
        </message>
        <message>
            <source>Layers</source>
            <translation>Слои</translation>
        </message>
        <message>
            <source>Batch</source>
            <translation>Партия</translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation>Варьирование</translation>
        </message>
        <message>
            <source>Optimise</source>
            <translation>Оптимизация</translation>
        </message>
        <message>
            <source>Compare</source>
            <translation>Сравнение</translation>
        </message>
        <message>
            <source>Measurements</source>
            <translation>Измерения</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>Remedies</source>
            <translation>Что поможет</translation>
        </message>
        <message>
            <source>Formulas of the step</source>
            <translation>Формулы этапа</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>Сообщения</translation>
        </message>
        <message>
            <source>Kept runs</source>
            <translation>Запомненные расчёты</translation>
        </message>
        <message>
            <source>Calibrate from measurements</source>
            <translation>Калибровка по измерениям</translation>
        </message>
        <message>
            <source>Examples</source>
            <translation>Примеры</translation>
        </message>
        <message>
            <source>Reports</source>
            <translation>Отчёты</translation>
        </message>
        <message>
            <source>Export results</source>
            <translation>Экспорт результатов</translation>
        </message>
        <message>
        <source>Interval and indices of the batch</source>
        <translation>Интервал и показатели партии</translation>
    </message>
        <message>
            <source>with √a, of the sources</source>
            <translation>с √a, по источникам</translation>
        </message>
        <message>
            <source>with a threshold</source>
            <translation>с порогом</translation>
        </message>
</context>
    <context>
        <name>CompareChart</name>
        <message>
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>Double strokes or revolutions done</source>
            <translation>Сделано двойных ходов или оборотов</translation>
        </message>
        <message>
            <source>Revolutions done</source>
            <translation>Выполнено оборотов</translation>
        </message>
        <message>
            <source>Double strokes done</source>
            <translation>Выполнено двойных ходов</translation>
        </message>
        <message>
            <source>Feed, µm</source>
            <translation>Подача, мкм</translation>
        </message>
        <message>
            <source>Force, N</source>
            <translation>Сила, Н</translation>
        </message>
        <message>
            <source>Σ feed, µm</source>
            <translation>Σ подача, мкм</translation>
        </message>
        <message>
            <source>Radius, µm</source>
            <translation>Радиус, мкм</translation>
        </message>
        <message>
            <source>Programmed, µm</source>
            <translation>Программ., мкм</translation>
        </message>
        <message>
            <source>Axial, mm/min</source>
            <translation>Продольная, мм/мин</translation>
        </message>
        <message>
            <source>Radius before, µm</source>
            <translation>Радиус до, мкм</translation>
        </message>
        <message>
            <source>Σ programmed, µm</source>
            <translation>Σ программ., мкм</translation>
        </message>
        <message>
            <source>%1: nothing is ground then</source>
            <translation>%1: в это время не шлифуется</translation>
        </message>
        <message>
            <source>double stroke %1</source>
            <translation>двойной ход %1</translation>
        </message>
        <message>
            <source>revolution %1</source>
            <translation>оборот %1</translation>
        </message>
        <message>
            <source>%1, %2: feed %3, accumulated %4, radius %5 µm; force %6 N</source>
            <translation>%1, %2: подача %3, накоплено %4, радиус %5 мкм; сила %6 Н</translation>
        </message>
        <message>
            <source>run</source>
            <translation>расчёт</translation>
        </message>
        <message>
            <source>stage</source>
            <translation>ступень</translation>
        </message>
        <message>
            <source>double stroke or revolution</source>
            <translation>двойной ход или оборот</translation>
        </message>
        <message>
            <source>%1: from</source>
            <comment>time</comment>
            <translation>%1: от</translation>
        </message>
        <message>
            <source>%1: to</source>
            <comment>time</comment>
            <translation>%1: до</translation>
        </message>
    </context>
    <context>
        <name>Condition</name>
        <message>
            <source>traverse</source>
            <translation>с продольной подачей</translation>
        </message>
        <message>
            <source>plunge</source>
            <translation>врезное</translation>
        </message>
        <message>
            <source>external</source>
            <translation>наружная поверхность</translation>
        </message>
        <message>
            <source>internal</source>
            <translation>отверстие</translation>
        </message>
        <message>
            <source>ellipse</source>
            <translation>овальность</translation>
        </message>
        <message>
            <source>eccentric</source>
            <translation>эксцентриситет</translation>
        </message>
        <message>
            <source>lobes</source>
            <translation>огранка</translation>
        </message>
        <message>
            <source>measured</source>
            <translation>измеренный профиль</translation>
        </message>
        <message>
            <source>between centres</source>
            <translation>в центрах</translation>
        </message>
        <message>
            <source>in a chuck</source>
            <translation>в патроне</translation>
        </message>
        <message>
            <source>gauge at a section</source>
            <translation>прибор в сечении</translation>
        </message>
        <message>
            <source>gauge at a free position</source>
            <translation>прибор в произвольном месте</translation>
        </message>
        <message>
            <source>gauge control</source>
            <translation>управление от прибора</translation>
        </message>
        <message>
            <source>position control</source>
            <translation>управление по положению</translation>
        </message>
        <message>
            <source>the stage feeds</source>
            <translation>ступень с подачей</translation>
        </message>
        <message>
            <source>the stage is a spark-out</source>
            <translation>ступень выхаживания</translation>
        </message>
        <message>
            <source>surface without gaps</source>
            <translation>сплошная поверхность</translation>
        </message>
        <message>
            <source>interrupted surface</source>
            <translation>прерывистая поверхность</translation>
        </message>
        <message>
            <source>no length of a wear flat</source>
            <translation>длина площадки износа не задана</translation>
        </message>
        <message>
            <source>a wear flat of a given length</source>
            <translation>длина площадки износа задана</translation>
        </message>
        <message>
            <source>force law of the sources</source>
            <translation>закон силы источников</translation>
        </message>
        <message>
            <source>force law with a threshold</source>
            <translation>закон силы с порогом</translation>
        </message>
        <message>
            <source>no machine&apos;s form</source>
            <translation>без формы от станка</translation>
        </message>
        <message>
            <source>with the machine&apos;s form</source>
            <translation>с формой от станка</translation>
        </message>
        <message>
            <source>runout of the wheel not given</source>
            <translation>биение круга не задано</translation>
        </message>
        <message>
            <source>runout of the wheel by its amplitude</source>
            <translation>биение круга задано амплитудой</translation>
        </message>
        <message>
            <source>unbalanced wheel</source>
            <translation>круг не уравновешен</translation>
        </message>
    </context>
    <context>
        <name>CouplingCurves</name>
        <message>
            <source>Coupling changes the diameter most at %2 mm, by %1 µm. Spread over the length: independent %3 µm, coupled %4 µm. Time: %5 and %6.</source>
            <translation>Разность связанных и независимых не более %1 мкм по диаметру, на %2 мм. Разброс по длине: независимые %3 мкм, связанные %4 мкм. Время %5 и %6.</translation>
        </message>
        <message>
            <source>Independent: %1</source>
            <translation>Независимые: %1</translation>
        </message>
        <message>
            <source>Coupled: %1</source>
            <translation>Связанные: %1</translation>
        </message>
        <message>
            <source>sections independent</source>
            <translation>сечения независимы</translation>
        </message>
        <message>
            <source>sections coupled</source>
            <translation>сечения связаны</translation>
        </message>
        <message>
            <source>coupled minus independent</source>
            <translation>разность: связаны минус независимы</translation>
        </message>
        <message>
            <source>Section</source>
            <translation>Сечение</translation>
        </message>
        <message>
            <source>Position, mm</source>
            <translation>Место, мм</translation>
        </message>
        <message>
            <source>Independent, mean diameter from the middle, µm</source>
            <translation>Независимые, средний диаметр от середины поля, мкм</translation>
        </message>
        <message>
            <source>Coupled, mean diameter from the middle, µm</source>
            <translation>Связанные, средний диаметр от середины поля, мкм</translation>
        </message>
        <message>
            <source>Difference, µm</source>
            <translation>Разность, мкм</translation>
        </message>
        <message>
            <source>%1 at %2 mm: independent %3 µm, coupled %4 µm, difference %5 µm</source>
            <translation>%1, %2 мм: независимые %3 мкм, связанные %4 мкм, разность %5 мкм</translation>
        </message>
    </context>
    <context>
        <name>RunFigures</name>
        <message>
            <source>Feeds by stage over the whole cycle</source>
            <translation>Подачи по ступеням за весь цикл</translation>
        </message>
        <message>
            <source>Cross-sections at the end of the cycle</source>
            <translation>Поперечные сечения в конце цикла</translation>
        </message>
        <message>
            <source>%1: actual feed over the stock left, under its limits</source>
            <translation>%1: фактическая подача в зависимости от оставшегося припуска и её ограничения</translation>
        </message>
    </context>
    <context>
        <name>CourseHandout</name>
        <message>
            <source>The step worked out</source>
            <translation>Разбор шага цикла</translation>
        </message>
        <message>
            <source>The cycle is too long to be recorded, so no step of it can be worked out.</source>
            <translation>Цикл слишком длинный и не записан, поэтому разобрать его шаг нельзя.</translation>
        </message>
        <message>
            <source>Every formula is printed in symbols, then with its numbers, then with its result. Numbers have as many digits as the printed result needs.</source>
            <translation>Каждая формула записана в обозначениях, затем с подставленными числами и с результатом. Числа подставлены со столькими знаками, сколько нужно для напечатанного результата.</translation>
        </message>
        <message>
            <source>Course hand-out</source>
            <translation>Раздаточный материал</translation>
        </message>
        <message>
            <source>The task</source>
            <translation>Задание</translation>
        </message>
        <message>
            <source>Stages of the cycle</source>
            <translation>Ступени цикла</translation>
        </message>
        <message>
            <source>Inputs of the formulas</source>
            <translation>Исходные данные формул</translation>
        </message>
        <message>
            <source>Charts</source>
            <translation>Графики</translation>
        </message>
        <message>
            <source>Questions</source>
            <translation>Вопросы</translation>
        </message>
        <message>
            <source>Sources</source>
            <translation>Источники</translation>
        </message>
        <message>
            <source>Answers</source>
            <translation>Ответы</translation>
        </message>
        <message>
            <source>Dynamic programming</source>
            <translation>Динамическое программирование</translation>
        </message>
    </context>
    <context>
        <name>Measured</name>
        <message>
            <source>the model agrees with the parts</source>
            <translation>модель согласуется с деталями</translation>
        </message>
        <message>
            <source>the mean differs from the predicted one</source>
            <translation>среднее отличается от прогноза</translation>
        </message>
        <message>
            <source>the parts scatter differently than predicted</source>
            <translation>рассеяние деталей отличается от прогноза</translation>
        </message>
        <message>
            <source>the mean differs from the predicted one, and the parts scatter differently</source>
            <translation>среднее отличается от прогноза, и рассеяние деталей тоже</translation>
        </message>
        <message>
            <source>too few parts for a conclusion</source>
            <translation>деталей слишком мало, чтобы судить</translation>
        </message>
        <message>
            <source>not predicted by this cycle</source>
            <translation>этим циклом не прогнозируется</translation>
        </message>
        <message>
            <source>found</source>
            <translation>найдено</translation>
        </message>
        <message>
            <source>the data leave some parameters undetermined</source>
            <translation>некоторые параметры по данным определить нельзя</translation>
        </message>
        <message>
            <source>there are too few measured values for these parameters</source>
            <translation>измеренных значений слишком мало для этих параметров</translation>
        </message>
        <message>
            <source>the project cannot have these parameters, one of them is given twice, or the setting of the gauge is to be fitted to traces</source>
            <translation>таких параметров у проекта быть не может, один из них указан дважды или настройка прибора определяется по записям</translation>
        </message>
        <message>
            <source>the cycle of the project cannot be run to size</source>
            <translation>цикл проекта не доходит до размера</translation>
        </message>
        <message>
            <source>no best values were found</source>
            <translation>наилучшие значения не найдены</translation>
        </message>
        <message>
            <source>the model does not fit: the residuals exceed the noise, a time, lag or drift is left out, a value lies outside its usual range, or an input would be refused</source>
            <translation>модель не подходит: остаётся больше случайного, не учтён сдвиг, запаздывание или дрейф, значение вне обычного диапазона или исходные данные с ним недопустимы</translation>
        </message>
        <message>
            <source>stopped</source>
            <translation>остановлено</translation>
        </message>
        <message>
            <source>record the wheel&apos;s power over the same cycle</source>
            <translation>запишите мощность привода круга за тот же цикл</translation>
        </message>
        <message>
            <source>record the normal force over the same cycle</source>
            <translation>запишите нормальную силу за тот же цикл</translation>
        </message>
        <message>
            <source>record the size at the gauge over a cycle</source>
            <translation>запишите размер по прибору за цикл</translation>
        </message>
        <message>
            <source>record a cycle with a stage at another feed, or with a spark-out</source>
            <translation>запишите цикл со ступенью на другой подаче или с выхаживанием</translation>
        </message>
        <message>
            <source>record the power before the wheel touches, too</source>
            <translation>запишите мощность и до касания круга</translation>
        </message>
        <message>
            <source>measure the size in these zones or sections</source>
            <translation>измерьте размер в этих зонах или сечениях</translation>
        </message>
        <message>
            <source>record a trace that has the beginning of the cut</source>
            <translation>сделайте запись, в которой есть начало резания</translation>
        </message>
        <message>
            <source>measure more parts</source>
            <translation>измерьте больше деталей</translation>
        </message>
        <message>
            <source>factor of α = γ·b·kₛ</source>
            <translation>множитель α = γ·b·kₛ</translation>
        </message>
        <message>
            <source>factor of β = γ·b·kᵣ</source>
            <translation>множитель β = γ·b·kᵣ</translation>
        </message>
        <message>
            <source>factor of the compliance γ</source>
            <translation>множитель податливости γ</translation>
        </message>
        <message>
            <source>factor of the flow stress σᵢ</source>
            <translation>множитель интенсивности напряжений σᵢ</translation>
        </message>
        <message>
            <source>factor of the dullness η</source>
            <translation>множитель затупления η</translation>
        </message>
        <message>
            <source>factor of b·kₜ·Vₖ</source>
            <translation>множитель b·kₜ·Vₖ</translation>
        </message>
        <message>
            <source>factor of b·μ·kᵣ·Vₖ</source>
            <translation>множитель b·μ·kᵣ·Vₖ</translation>
        </message>
        <message>
            <source>idle power</source>
            <translation>мощность холостого хода</translation>
        </message>
        <message>
            <source>offset of the gauge</source>
            <translation>смещение прибора</translation>
        </message>
        <message>
            <source>beginning of the cycle in the trace</source>
            <translation>начало цикла в записи</translation>
        </message>
        <message>
            <source>the difference grows with time, as when a gauge or a sensor drifts</source>
            <translation>разность растёт со временем, как при дрейфе прибора или датчика</translation>
        </message>
        <message>
            <source>the trace lags where it changes fast, as with a damped gauge or a filter</source>
            <translation>запись запаздывает там, где быстро меняется, как у демпфированного прибора или после фильтра</translation>
        </message>
        <message>
            <source>the difference lies in one stage: is its feed that of the recording?</source>
            <translation>разность приходится на одну ступень: та ли у неё подача, что при записи?</translation>
        </message>
        <message>
            <source>the difference lies in a few outliers: give them less weight, or leave them out</source>
            <translation>разность создают несколько выпавших значений: уменьшите вес выбросов или исключите их</translation>
        </message>
        <message>
            <source>the project and the recording differ in something other than these parameters</source>
            <translation>проект и запись различаются чем-то кроме этих параметров</translation>
        </message>
        <message>
            <source>readings so far beyond all others come from a sensor at the end of its range: leave them out, or give outliers less weight</source>
            <translation>показания так далеко от всех остальных даёт датчик на пределе своего диапазона: исключите их или уменьшите вес выбросов</translation>
        </message>
        <message>
            <source>runout of the blank</source>
            <translation>биение заготовки</translation>
        </message>
        <message>
            <source>time constant of the gauge</source>
            <translation>постоянная времени прибора</translation>
        </message>
        <message>
            <source>time constant of the power&apos;s filter</source>
            <translation>постоянная времени фильтра мощности</translation>
        </message>
        <message>
            <source>time constant of the force&apos;s filter</source>
            <translation>постоянная времени фильтра силы</translation>
        </message>
        <message>
            <source>drift of the gauge</source>
            <translation>дрейф прибора</translation>
        </message>
        <message>
            <source>setting of the gauge</source>
            <translation>настройка прибора</translation>
        </message>
        <message>
            <source>size at the gauge</source>
            <translation>размер по прибору</translation>
        </message>
        <message>
            <source>power of the wheel</source>
            <translation>мощность привода круга</translation>
        </message>
        <message>
            <source>normal force</source>
            <translation>нормальная сила</translation>
        </message>
        <message>
            <source>diameters of parts</source>
            <translation>диаметры деталей</translation>
        </message>
        <message>
            <source>delay of the power trace</source>
            <translation>запаздывание записи мощности</translation>
        </message>
        <message>
            <source>delay of the force trace</source>
            <translation>запаздывание записи силы</translation>
        </message>
        <message>
            <source>factor of the specific normal force K₀</source>
            <translation>множитель удельной нормальной силы K₀</translation>
        </message>
        <message>
            <source>factor of the threshold force F′₀</source>
            <translation>множитель пороговой силы F′₀</translation>
        </message>
        <message>
            <source>factor of b·K_z·Vₖ</source>
            <translation>множитель b·K_z·Vₖ</translation>
        </message>
        <message>
            <source>factor of b·μ·F′₀·Vₖ</source>
            <translation>множитель b·μ·F′₀·Vₖ</translation>
        </message>
        <message>
            <source>the spark-out supports the sources&apos; force law</source>
            <translation>выхаживание подтверждает закон силы источников</translation>
        </message>
        <message>
            <source>the spark-out supports the force law with a threshold</source>
            <translation>выхаживание подтверждает закон силы с порогом</translation>
        </message>
        <message>
            <source>the spark-out does not separate the two force laws</source>
            <translation>выхаживание не разделяет два закона силы</translation>
        </message>
        <message>
            <source>removed after the last feed, on the diameter</source>
            <translation>снято после последней подачи, по диаметру</translation>
        </message>
        <message>
            <source>mean wheel power over the feeds</source>
            <translation>средняя мощность привода круга при рабочих подачах</translation>
        </message>
        <message>
            <source>time from the middle of the first feed to the end of the last one, between the same two sizes</source>
            <translation>время от середины первой подачи до конца последней, между теми же двумя размерами</translation>
        </message>
    </context>
    <context>
        <name>OperationCard</name>
        <message>
            <source>Cylindrical grinding, several surfaces</source>
            <translation>Круглошлифовальная, несколько поверхностей</translation>
        </message>
        <message>
            <source>%1 (%2)</source>
            <translation>%1 («%2»)</translation>
        </message>
        <message>
            <source>radial runout</source>
            <translation>радиальное биение</translation>
        </message>
        <message>
            <source>total runout</source>
            <translation>полное радиальное биение</translation>
        </message>
        <message>
            <source>roundness</source>
            <translation>отклонение от круглости</translation>
        </message>
        <message>
            <source>cylindricity</source>
            <translation>отклонение от цилиндричности</translation>
        </message>
        <message>
            <source>Chuck</source>
            <translation>Патрон</translation>
        </message>
        <message>
            <source>Centres</source>
            <translation>Центры</translation>
        </message>
        <message>
            <source>driving carrier</source>
            <translation>хомутик поводковый</translation>
        </message>
        <message>
            <source>steady rests: %1</source>
            <translation>люнеты: %1</translation>
        </message>
        <message>
            <source>Grind surface %1 by traverse grinding to %2</source>
            <translation>Шлифовать поверхность %1 с продольной подачей в размер %2</translation>
        </message>
        <message>
            <source>Grind surface %1 by plunge grinding to %2</source>
            <translation>Шлифовать поверхность %1 с врезной подачей в размер %2</translation>
        </message>
        <message>
            <source>Grind bore %1 by traverse grinding to %2</source>
            <translation>Шлифовать отверстие %1 с продольной подачей в размер %2</translation>
        </message>
        <message>
            <source>Grind bore %1 by plunge grinding to %2</source>
            <translation>Шлифовать отверстие %1 с врезной подачей в размер %2</translation>
        </message>
        <message>
            <source> over a length of %1</source>
            <translation> на длине %1</translation>
        </message>
        <message>
            <source>, holding: %1</source>
            <translation>, выдержать: %1</translation>
        </message>
        <message>
            <source>. Stock per side %1; wheel speed %2 m/s</source>
            <translation>. Припуск на сторону %1; скорость круга %2 м/с</translation>
        </message>
        <message>
            <source>Wheel %1</source>
            <translation>Круг %1</translation>
        </message>
        <message>
            <source>Wheel %1, %2</source>
            <translation>Круг %1, %2</translation>
        </message>
        <message>
            <source>in-process gauge</source>
            <translation>прибор активного контроля</translation>
        </message>
        <message>
            <source>overrun at the entry %1, at the exit %2 mm</source>
            <translation>перебег на входе %1, на выходе %2 мм</translation>
        </message>
        <message>
            <source>dwell at the entry %1, at the exit %2 s</source>
            <translation>выстой на входе %1, на выходе %2 с</translation>
        </message>
        <message>
            <source>plunge-in at a reversal %1 mm/min</source>
            <translation>врезание на реверсе %1 мм/мин</translation>
        </message>
        <message>
            <source>stages end by the position of the wheel head</source>
            <translation>ступени заканчиваются по положению шлифовальной бабки</translation>
        </message>
        <message>
            <source>gauge commands at a stock per side of %1 mm</source>
            <translation>команды прибора при припуске на сторону %1 мм</translation>
        </message>
        <message>
            <source>This cycle was not run.</source>
            <translation>Цикл не рассчитан.</translation>
        </message>
        <message>
            <source>Stage %1: </source>
            <translation>Ступень %1: </translation>
        </message>
        <message>
            <source>i in double strokes</source>
            <translation>i в дв. ходах</translation>
        </message>
        <message>
            <source>i in revolutions</source>
            <translation>i в оборотах</translation>
        </message>
        <message>
            <source>spark-out until size, %1</source>
            <translation>выхаживание до размера, %1</translation>
        </message>
        <message>
            <source>spark-out, %1</source>
            <translation>выхаживание, %1</translation>
        </message>
        <message>
            <source>S radial, mm/min</source>
            <translation>S радиальная, мм/мин</translation>
        </message>
        <message>
            <source>S radial, mm per double stroke</source>
            <translation>S радиальная, мм/дв. ход</translation>
        </message>
        <message>
            <source>retraction, mm/min</source>
            <translation>отвод, мм/мин</translation>
        </message>
        <message>
            <source> / axial, mm/min</source>
            <translation> / продольная, мм/мин</translation>
        </message>
        <message>
            <source>; continuous %1 mm/min</source>
            <translation>; непрерывная %1 мм/мин</translation>
        </message>
        <message>
            <source>Bore comparator</source>
            <translation>Нутромер индикаторный</translation>
        </message>
        <message>
            <source>Indicating calliper</source>
            <translation>Скоба индикаторная</translation>
        </message>
        <message>
            <source>dial indicator with stand</source>
            <translation>индикатор со стойкой</translation>
        </message>
        <message>
            <source>roundness tester</source>
            <translation>кругломер</translation>
        </message>
        <message>
            <source>roughness tester</source>
            <translation>профилометр</translation>
        </message>
        <message>
            <source>Load the part and clamp it in the chuck</source>
            <translation>Установить и закрепить деталь в патроне</translation>
        </message>
        <message>
            <source>Load the part between centres and clamp it</source>
            <translation>Установить и закрепить деталь в центрах</translation>
        </message>
        <message>
            <source>Dress the wheel as its dullness requires</source>
            <translation>Править круг по мере затупления</translation>
        </message>
        <message>
            <source>Check surface %1: %2</source>
            <translation>Контролировать поверхность %1: %2</translation>
        </message>
        <message>
            <source>Take the part off</source>
            <translation>Снять деталь</translation>
        </message>
        <message>
            <source>O</source>
            <comment>service symbol of a transition</comment>
            <translation>О</translation>
        </message>
        <message>
            <source>T</source>
            <comment>service symbol of tooling</comment>
            <translation>Т</translation>
        </message>
        <message>
            <source>R</source>
            <comment>service symbol of regimes</comment>
            <translation>Р</translation>
        </message>
        <message>
            <source>kg</source>
            <translation>кг</translation>
        </message>
        <message>
            <source>Operation card</source>
            <translation>Операционная карта</translation>
        </message>
        <message>
            <source>Sketch sheet</source>
            <translation>Карта эскизов</translation>
        </message>
        <message>
            <source>Dress the wheel as its dullness requires: %1</source>
            <translation>Править круг по мере затупления: %1</translation>
        </message>
        <message>
            <source>; gaps of the surface: %1</source>
            <translation>; пазов на поверхности: %1</translation>
        </message>
        <message>
            <source>Check surfaces %1</source>
            <translation>Контролировать поверхности %1</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <comment>surface, its size</comment>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>%1; each: %2</source>
            <comment>surfaces, tolerances</comment>
            <translation>%1; каждая: %2</translation>
        </message>
    </context>
    <context>
        <name>Output</name>
        <message>
            <source>Double strokes</source>
            <translation>Двойные ходы</translation>
        </message>
        <message>
            <source>Revolutions</source>
            <translation>Обороты</translation>
        </message>
        <message>
            <source>Number completed in the stage.</source>
            <translation>Сколько их заняла ступень.</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>Machining time of the stage.</source>
            <translation>Основное время ступени.</translation>
        </message>
        <message>
            <source>Maximum actual feed</source>
            <translation>Наибольшая фактическая подача</translation>
        </message>
        <message>
            <source>Q′w</source>
            <translation>Q′w</translation>
        </message>
        <message>
            <source>Specific removal rate Q′_w = π·d·n·a/60: volume removed in a second by each millimetre of the width that cuts, at the maximum actual feed a of the stage. No band holds for every wheel: compare with cycles known to be good.</source>
            <translation>Удельная интенсивность съёма Q′_w = π·d·n·a/60: объём металла, снимаемый за секунду каждым миллиметром режущей ширины, при наибольшей фактической подаче a на ступени. Границ, верных для любого круга, нет: сравнивайте с проверенными циклами.</translation>
        </message>
        <message>
            <source>Mean Q′w</source>
            <translation>Среднее Q′w</translation>
        </message>
        <message>
            <source>   mean</source>
            <translation>   среднее</translation>
        </message>
        <message>
            <source>The specific removal rate at the mean actual feed of all passes of the stage, including those that remove nothing.</source>
            <translation>Удельная интенсивность съёма при средней фактической подаче по всем проходам ступени, включая проходы без съёма.</translation>
        </message>
        <message>
            <source>heq</source>
            <translation>hэкв</translation>
        </message>
        <message>
            <source>Equivalent chip thickness h_eq = Q′_w/V_k, at the maximum actual feed of the stage: the layer of metal that leaves at the wheel&apos;s speed. Forces and roughness rise with it. No band holds for every wheel: compare with cycles known to be good.</source>
            <translation>Эквивалентная толщина среза h_экв = Q′_w/V_k при наибольшей фактической подаче на ступени: слой металла, уходящий со скоростью круга. С ней растут силы и шероховатость. Границ, верных для любого круга, нет: сравнивайте с проверенными циклами.</translation>
        </message>
        <message>
            <source>Aggressiveness</source>
            <translation>Агрессивность</translation>
        </message>
        <message>
            <source>Aggressiveness 10⁶·(V_d/V_k)·√(a/D_e), at the maximum actual feed of the stage: how hard the contact loads a grain, for wheels of any size. Large, the grains break out; small, they rub. No band holds for every wheel: compare with cycles known to be good.</source>
            <translation>Агрессивность 10⁶·(V_d/V_k)·√(a/D_e) при наибольшей фактической подаче на ступени: насколько контакт нагружает зерно, для кругов любого размера. При большой зёрна выкрашиваются, при малой — трут. Границ, верных для любого круга, нет: сравнивайте с проверенными циклами.</translation>
        </message>
        <message>
            <source>Overlap B/s</source>
            <translation>Коэф. перекр. B/s</translation>
        </message>
        <message>
            <source>Overlap ratio B/s_ax, s_ax = S_ax/n: how many revolutions a place of the surface is under the wheel in one stroke. Below 1 strips stay unground. For the cycle: the least of its stages.</source>
            <translation>Коэффициент перекрытия B/s_ax, s_ax = S_ax/n: сколько оборотов место поверхности находится под кругом за один ход. При значении меньше 1 остаются непрошлифованные полосы. Для цикла — наименьший по ступеням.</translation>
        </message>
        <message>
            <source>Energy</source>
            <translation>Энергия</translation>
        </message>
        <message>
            <source>Specific energy: ∫P_z·V_k dt over the volume removed. Plausible for steel: 20…120 J/mm³. A dull wheel needs more; so does spark-out, where the wheel rubs more than it cuts.</source>
            <translation>Удельная энергия шлифования: ∫P_z·V_k dt на снятый объём. Правдоподобно для стали: 20…120 Дж/мм³. Затупленному кругу нужно больше; при выхаживании тоже: круг больше трёт, чем режет.</translation>
        </message>
        <message>
            <source>Maximum power</source>
            <translation>Наибольшая мощность</translation>
        </message>
        <message>
            <source>Power</source>
            <translation>Мощность</translation>
        </message>
        <message>
            <source>Maximum wheel power P_z·V_k of any pass of the stage.</source>
            <translation>Наибольшая мощность шлифования P_z·V_k по проходам ступени.</translation>
        </message>
        <message>
            <source>Mean power</source>
            <translation>Средняя мощность</translation>
        </message>
        <message>
            <source>Mean wheel power: the energy over the machining time of the stage, in all of which the wheel grinds: plunging, dwells and strokes of the table.</source>
            <translation>Средняя мощность шлифования: энергия, делённая на основное время ступени; круг шлифует всё это время — при врезании, выстоях и ходах стола.</translation>
        </message>
        <message>
            <source>Maximum force Py</source>
            <translation>Наибольшая сила Py</translation>
        </message>
        <message>
            <source>Force Py</source>
            <translation>Сила Py</translation>
        </message>
        <message>
            <source>Maximum normal force P_y of any pass of the stage.</source>
            <translation>Наибольшая нормальная сила P_y по проходам ступени.</translation>
        </message>
        <message>
            <source>Volume removed</source>
            <translation>Снятый объём</translation>
        </message>
        <message>
            <source>Total energy</source>
            <translation>Полная энергия</translation>
        </message>
        <message>
            <source>Wheel speed</source>
            <translation>Частота вращения круга</translation>
        </message>
        <message>
            <source>Rotation ratio</source>
            <translation>Частоты n_к : n</translation>
        </message>
        <message>
            <source>Wheel rev/min to work rev/min. Within 0.05 of a whole number the waves of a wheel out of true print onto one another: over ten revolutions they shift by less than half of their length.</source>
            <translation>Отношение частот вращения круга и детали. Ближе 0,05 к целому числу волны от биения круга ложатся одна на другую: за десять оборотов они сдвигаются меньше чем на половину своей длины.</translation>
        </message>
        <message>
            <source>Lower limit</source>
            <translation>Нижний предел</translation>
        </message>
        <message>
            <source>Upper limit</source>
            <translation>Верхний предел</translation>
        </message>
        <message>
            <source>Values</source>
            <translation>Число значений</translation>
        </message>
        <message>
            <source>Minimum</source>
            <translation>Наименьшее</translation>
        </message>
        <message>
            <source>Maximum</source>
            <translation>Наибольшее</translation>
        </message>
        <message>
            <source>Mean</source>
            <translation>Среднее</translation>
        </message>
        <message>
            <source>Mean, 95 %</source>
            <translation>Среднее, 95 %</translation>
        </message>
        <message>
            <source>Student&apos;s interval: with 95 % confidence it contains the mean of an unlimited number of such parts</source>
            <translation>Интервал Стьюдента: среднее сколь угодно большого числа таких деталей лежит в нём с вероятностью 95 %</translation>
        </message>
        <message>
            <source>s</source>
            <translation>s</translation>
        </message>
        <message>
            <source>Standard deviation of the sample</source>
            <translation>Стандартное отклонение выборки</translation>
        </message>
        <message>
            <source>Skewness</source>
            <translation>Асимметрия</translation>
        </message>
        <message>
            <source>Excess kurtosis</source>
            <translation>Эксцесс</translation>
        </message>
        <message>
            <source>Pp</source>
            <translation>Pp</translation>
        </message>
        <message>
            <source>Width of the field over 6 s, with 95 % bounds; s is that of all parts and includes any drift over the batch. Without drift Pp equals Cp</source>
            <translation>Ширина поля допуска, делённая на 6 s, с 95%-ными границами; s — по всем деталям, вместе с тем, что изменяется по ходу партии. Если ничто не изменяется, это Cp</translation>
        </message>
        <message>
            <source>Ppk</source>
            <translation>Ppk</translation>
        </message>
        <message>
            <source>Distance from the mean to the nearer limit over 3 s, with 95 % bounds; it is meaningful for a normal quantity. A dash: not a size or form of the part, or one that hardly scatters beside its field</source>
            <translation>Расстояние от среднего до ближнего предела, делённое на 3 s, с 95%-ными границами; полный смысл имеет при нормальном распределении. Прочерк: не размер и не форма детали, или рассеяние ничтожно по сравнению с полем</translation>
        </message>
        <message>
            <source>Out of tolerance</source>
            <translation>Вне допуска</translation>
        </message>
        <message>
            <source>Parts beyond the limits, as a share with the 95 % bounds of Clopper and Pearson</source>
            <translation>Детали за пределами допуска: число и доля с границами 95 % по Клопперу — Пирсону</translation>
        </message>
        <message>
            <source>Expected share out of tolerance</source>
            <translation>Ожидаемая доля вне допуска</translation>
        </message>
        <message>
            <source>Normality, p</source>
            <translation>Нормальность, p</translation>
        </message>
        <message>
            <source>Probability that normal values deviate so much from the normal law, by the test of Shapiro and Wilk, of more than 4096 parts of Anderson and Darling; below 0.05 the values are called not normal</source>
            <translation>Вероятность такого отклонения от нормального закона при нормальном распределении по критерию Шапиро — Уилка, свыше 4096 деталей — Андерсона — Дарлинга; если она меньше 0,05, распределение названо не нормальным</translation>
        </message>
        <message>
            <source>From the headstock end</source>
            <translation>От конца у передней бабки</translation>
        </message>
        <message>
            <source>Compliance</source>
            <translation>Податливость</translation>
        </message>
        <message>
            <source>Roundness, minimum zone</source>
            <translation>Отклонение от круглости, минимальная зона</translation>
        </message>
        <message>
            <source>Roundness</source>
            <translation>Откл. от круглости</translation>
        </message>
        <message>
            <source>Minimum zone, of the least round section of the zone.</source>
            <translation>Минимальная зона, по наименее круглому сечению зоны.</translation>
        </message>
        <message>
            <source>Minimum diameter from nominal</source>
            <translation>Отклонение наименьшего диаметра</translation>
        </message>
        <message>
            <source>Maximum diameter from nominal</source>
            <translation>Отклонение наибольшего диаметра</translation>
        </message>
        <message>
            <source>Radial runout</source>
            <translation>Радиальное биение</translation>
        </message>
        <message>
            <source>Roundness, least squares</source>
            <translation>Отклонение от круглости, наименьшие квадраты</translation>
        </message>
        <message>
            <source>Maximum normal force</source>
            <translation>Наибольшая нормальная сила</translation>
        </message>
        <message>
            <source>Roughness Ra</source>
            <translation>Шероховатость Ra</translation>
        </message>
        <message>
            <source>Maximum roughness Ra of the estimate</source>
            <translation>Наибольшая шероховатость Ra по оценке</translation>
        </message>
        <message>
            <source>Minimum diameter with even lobes, from nominal</source>
            <translation>Наименьший диаметр при чётном числе граней, от номинала</translation>
        </message>
        <message>
            <source>Maximum diameter with even lobes, from nominal</source>
            <translation>Наибольший диаметр при чётном числе граней, от номинала</translation>
        </message>
        <message>
            <source>Cylindricity, minimum zone</source>
            <translation>Отклонение от цилиндричности, минимальная зона</translation>
        </message>
        <message>
            <source>Cylindricity</source>
            <translation>Откл. от цилиндр.</translation>
        </message>
        <message>
            <source>Minimum zone, over all sections of the zone.</source>
            <translation>Минимальная зона, по всем сечениям зоны.</translation>
        </message>
        <message>
            <source>Total runout</source>
            <translation>Полное биение</translation>
        </message>
        <message>
            <source>About the centre axis, over all sections, including the machine&apos;s own runout.</source>
            <translation>Относительно оси центров, по всем сечениям, вместе с биением станка.</translation>
        </message>
        <message>
            <source>Taper</source>
            <translation>Конусообразность</translation>
        </message>
        <message>
            <source>Mean radius at the zone&apos;s last section minus that at its first, on the straight line through them.</source>
            <translation>Средний радиус последнего сечения зоны за вычетом первого, по прямой через них.</translation>
        </message>
        <message>
            <source>Crown</source>
            <translation>Бочкообразность</translation>
        </message>
        <message>
            <source>Mean radius in the zone&apos;s middle minus that at its ends: above 0 a barrel, below it a saddle.</source>
            <translation>Средний радиус в середине зоны за вычетом радиуса на концах: больше 0 — бочка, меньше — седло.</translation>
        </message>
        <message>
            <source>Time of the cycle found</source>
            <translation>Время найденного цикла</translation>
        </message>
        <message>
            <source>Minimum margin of all requirements, relative to its limit</source>
            <translation>Наименьший запас по всем требованиям, от предела</translation>
        </message>
        <message>
            <source>Cost of a part with its share of the dressing</source>
            <translation>Стоимость детали с её долей правки</translation>
        </message>
        <message>
            <source>Stepless limit</source>
            <translation>Предел бесступенчатого цикла</translation>
        </message>
        <message>
            <source>Excess over the stepless limit</source>
            <translation>Превышение предела бесступенчатого цикла</translation>
        </message>
        <message>
            <source>No cycle of the grid is quicker than</source>
            <translation>Ни один цикл сетки не быстрее</translation>
        </message>
        <message>
            <source>Cycles in the grid</source>
            <translation>Циклов в сетке</translation>
        </message>
        <message>
            <source>Rounds of levels</source>
            <translation>Приближений уровней</translation>
        </message>
        <message>
            <source>Cycles judged</source>
            <translation>Проверено циклов</translation>
        </message>
        <message>
            <source>Radii under the wheel in all runs</source>
            <translation>Проходов радиусов под кругом во всех расчётах</translation>
        </message>
        <message>
            <source>Scenarios added</source>
            <translation>Добавлено сценариев</translation>
        </message>
        <message>
            <source>Time of the quickest cycle for the part alone</source>
            <translation>Время самого быстрого цикла для одной номинальной детали</translation>
        </message>
        <message>
            <source>n</source>
            <translation>n</translation>
        </message>
        <message>
            <source>Number of measured parts</source>
            <translation>Число измеренных деталей</translation>
        </message>
        <message>
            <source>Mean of the measured parts with Student&apos;s interval: with 95 % confidence it contains the mean of an unlimited number of such parts</source>
            <translation>Среднее измеренных деталей с интервалом Стьюдента: в нём с вероятностью 95 % лежит среднее бесконечно многих таких деталей</translation>
        </message>
        <message>
            <source>Predicted mean</source>
            <translation>Прогноз, среднее</translation>
        </message>
        <message>
            <source>Predicted from</source>
            <translation>Прогноз от</translation>
        </message>
        <message>
            <source>Range that contains 95 % of the parts of the batch; of corners, all of them</source>
            <translation>Диапазон, в котором лежат 95 % деталей партии; у крайних сочетаний — все</translation>
        </message>
        <message>
            <source>Predicted to</source>
            <translation>Прогноз до</translation>
        </message>
        <message>
            <source>Predicted s</source>
            <translation>Прогноз, s</translation>
        </message>
        <message>
            <source>F</source>
            <translation>F</translation>
        </message>
        <message>
            <source>Variance of the measured parts over that of the batch, with the limits that chance leaves it within in 95 % of cases: Fisher&apos;s test</source>
            <translation>Дисперсия измеренных деталей к дисперсии партии и границы, в которых отношение с вероятностью 95 % бывает случайно: критерий Фишера</translation>
        </message>
        <message>
            <source>F, 95 % from</source>
            <translation>F, 95 % от</translation>
        </message>
        <message>
            <source>F, 95 % to</source>
            <translation>F, 95 % до</translation>
        </message>
        <message>
            <source>Parts inside</source>
            <translation>Деталей внутри</translation>
        </message>
        <message>
            <source>Share inside</source>
            <translation>Доля внутри</translation>
        </message>
        <message>
            <source>Measured parts within the predicted range, as a share with the 95 % bounds of Clopper and Pearson</source>
            <translation>Измеренные детали в прогнозном диапазоне, доля с 95 %-ными границами Клоппера и Пирсона</translation>
        </message>
        <message>
            <source>Bias</source>
            <translation>Смещение</translation>
        </message>
        <message>
            <source>Measured minus predicted mean: Welch&apos;s interval, 95 %, with the measuring uncertainty</source>
            <translation>Измеренное среднее минус прогнозируемое: интервал Уэлча, 95 %, с неопределённостью измерения</translation>
        </message>
        <message>
            <source>Limit of bias</source>
            <translation>Предел смещения</translation>
        </message>
        <message>
            <source>Largest difference at which the two means count as the same</source>
            <translation>До него оба средних считаются одинаковыми</translation>
        </message>
        <message>
            <source>Waviness</source>
            <translation>Волнистость</translation>
        </message>
        <message>
            <source>From peak to valley, of the profile without the orders below half of the wheel&apos;s; of the most wavy section.</source>
            <translation>От вершины до впадины профиля без гармоник ниже половины порядка круга; в самом волнистом сечении.</translation>
        </message>
        <message>
            <source>Largest order</source>
            <translation>Порядок наибольшей гармоники</translation>
        </message>
        <message>
            <source>Waves around the part of the harmonic with the largest amplitude.</source>
            <translation>Число волн по окружности детали у гармоники с наибольшей амплитудой.</translation>
        </message>
        <message>
            <source>Amplitude of the largest order</source>
            <translation>Амплитуда наибольшей гармоники</translation>
        </message>
        <message>
            <source>Waves that the wheel prints</source>
            <translation>Волны от круга</translation>
        </message>
        <message>
            <source>Number around the part, by the ratio of wheel to work speed and the waves of the wheel.</source>
            <translation>Число по окружности детали: по отношению частот вращения круга и заготовки и числу волн круга.</translation>
        </message>
        <message>
            <source>Source of the waves</source>
            <translation>Источник волн</translation>
        </message>
        <message>
            <source>Frequency</source>
            <translation>Частота</translation>
        </message>
        <message>
            <source>Of the source; none where it is fixed to the work.</source>
            <translation>Источника; нет, если он связан с деталью.</translation>
        </message>
        <message>
            <source>Waves of the wheel</source>
            <translation>Число волн круга</translation>
        </message>
        <message>
            <source>Number of waves around the wheel that this would take.</source>
            <translation>Сколько волн по окружности круга для этого нужно.</translation>
        </message>
        <message>
            <source>Turns of the work</source>
            <translation>Оборотов</translation>
        </message>
        <message>
            <source>After so many turns the waves meet those before.</source>
            <translation>Через столько оборотов волны попадают на прежние.</translation>
        </message>
        <message>
            <source>Waves it would leave</source>
            <translation>Волн оставит</translation>
        </message>
        <message>
            <source>At the other work speed</source>
            <translation>При другой частоте заготовки</translation>
        </message>
        <message>
            <source>At the other wheel speed</source>
            <translation>При другой частоте круга</translation>
        </message>
        <message>
            <source>Other work speed</source>
            <translation>Другая частота детали</translation>
        </message>
        <message>
            <source>Other wheel speed</source>
            <translation>Другая частота круга</translation>
        </message>
    </context>
    <context>
        <name>OutputCells</name>
        <message>
            <source>%1, 95 % from</source>
            <translation>%1, 95 % от</translation>
        </message>
        <message>
            <source>%1, 95 % to</source>
            <translation>%1, 95 % до</translation>
        </message>
        <message>
            <source>%1, share</source>
            <translation>%1, доля</translation>
        </message>
    </context>
    <context>
        <name>RequirementCells</name>
        <message>
            <source>not calibrated</source>
            <translation>не откалибровано</translation>
        </message>
        <message>
            <source>Ra, µm</source>
            <translation>Ra, мкм</translation>
        </message>
        <message>
            <source>Ra, µm, not calibrated</source>
            <translation>Ra, мкм, не откалибровано</translation>
        </message>
    </context>
    <context>
        <name>SketchSheet</name>
        <message>
            <source>A</source>
            <comment>datum</comment>
            <translation>А</translation>
        </message>
        <message>
            <source>B</source>
            <comment>datum</comment>
            <translation>Б</translation>
        </message>
        <message>
            <source>No.</source>
            <translation>№</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Размер</translation>
        </message>
        <message>
            <source>Ra</source>
            <translation>Ra</translation>
        </message>
        <message>
            <source>Tolerances, mm</source>
            <translation>Допуски, мм</translation>
        </message>
        <message>
            <source>L, mm</source>
            <translation>L, мм</translation>
        </message>
        <message>
            <source>From the end, mm</source>
            <translation>От торца, мм</translation>
        </message>
        <message>
            <source>arrows onto the part: chuck with 3 jaws</source>
            <translation>стрелки к детали — трёхкулачковый патрон</translation>
        </message>
        <message>
            <source>angles at the ends: centres</source>
            <translation>углы у торцов — центры</translation>
        </message>
        <message>
            <source>arrow below: driver</source>
            <translation>стрелка снизу — поводок</translation>
        </message>
        <message>
            <source>triangles: steady rests</source>
            <translation>треугольники — люнеты</translation>
        </message>
        <message>
            <source>lines of double width: surfaces ground</source>
            <translation>линии двойной толщины — шлифуемые поверхности</translation>
        </message>
        <message>
            <source>arrows at them: feed of the wheel</source>
            <translation>стрелки у них — подача круга</translation>
        </message>
        <message>
            <source>outer form assumed</source>
            <translation>наружный контур принят условно</translation>
        </message>
        <message>
            <source>Signs: %1.</source>
            <translation>Обозначения: %1.</translation>
        </message>
        <message>
            <source>length %1 mm, %2 mm from the end</source>
            <translation>длина %1 мм, %2 мм от торца</translation>
        </message>
        <message>
            <source>surface %1: %2</source>
            <translation>поверхность %1: %2</translation>
        </message>
        <message>
            <source>of roundness</source>
            <translation>круглости</translation>
        </message>
        <message>
            <source>of cylindricity</source>
            <translation>цилиндричности</translation>
        </message>
        <message>
            <source>of radial runout</source>
            <translation>радиального биения</translation>
        </message>
        <message>
            <source>of total runout</source>
            <translation>полного биения</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StateGridBar</name>
        <message>
            <source>Pause</source>
            <translation>Пауза</translation>
        </message>
        <message>
            <source>Play the filling of the grid</source>
            <translation>Показать заполнение сетки</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 из %2</translation>
        </message>
        <message>
            <source>Stopped before the grid was filled. Press “Run”.</source>
            <translation>Остановлено до заполнения сетки. Нажмите «Рассчитать».</translation>
        </message>
        <message>
            <source>levels </source>
            <translation>уровней </translation>
        </message>
        <message>
            <source>stages ≤ </source>
            <translation>ступеней ≤ </translation>
        </message>
        <message>
            <source>Number of levels of the stock</source>
            <translation>Число уровней, на которые разделён припуск</translation>
        </message>
        <message>
            <source>Stages that a cycle of the grid may have, within the gauge&apos;s commands</source>
            <translation>Наибольшее число ступеней цикла сетки, не более числа команд прибора</translation>
        </message>
        <message>
            <source>Run</source>
            <translation>Рассчитать</translation>
        </message>
        <message>
            <source>Fill the grid and prove the answer; this also starts by itself after an edit</source>
            <translation>Заполнить сетку и доказать ответ; после правки это выполняется само</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Остановить</translation>
        </message>
        <message>
            <source>Stop the run; the results so far are kept</source>
            <translation>Остановить расчёт; рассчитанное сохраняется</translation>
        </message>
        <message>
            <source>State of the filling</source>
            <translation>Что заполнено</translation>
        </message>
        <message>
            <source>Progress of the grid and its proof</source>
            <translation>Ход заполнения сетки и доказательства</translation>
        </message>
        <message>
            <source>To the blank</source>
            <translation>К заготовке</translation>
        </message>
        <message>
            <source>One state back</source>
            <translation>На одно состояние назад</translation>
        </message>
        <message>
            <source>The next state</source>
            <translation>Следующее состояние</translation>
        </message>
        <message>
            <source>To the end of the backtracking</source>
            <translation>К концу обратного хода</translation>
        </message>
        <message>
            <source>State shown</source>
            <translation>Рассматриваемое состояние</translation>
        </message>
        <message>
            <source>Number of the state shown</source>
            <translation>Номер рассматриваемого состояния</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StateGridPlot</name>
        <message>
            <source>Wrong: %1</source>
            <translation>Ошибка: %1</translation>
        </message>
        <message>
            <source>Level n</source>
            <translation>Уровень n</translation>
        </message>
        <message>
            <source>Stock left per side, mm</source>
            <translation>Оставшийся припуск на сторону, мм</translation>
        </message>
        <message>
            <source>Feed m</source>
            <translation>Подача m</translation>
        </message>
        <message>
            <source>Radial feed, mm per double stroke</source>
            <translation>Радиальная подача, мм на двойной ход</translation>
        </message>
        <message>
            <source>Radial feed, mm/min</source>
            <translation>Радиальная подача, мм/мин</translation>
        </message>
        <message>
            <source>Axial feed, mm/min</source>
            <translation>Продольная подача, мм/мин</translation>
        </message>
        <message>
            <source>m*</source>
            <translation>m*</translation>
        </message>
        <message>
            <source>Moves struck out</source>
            <translation>Вычеркнутые ходы</translation>
        </message>
        <message>
            <source>States in which the rule is wrong</source>
            <translation>Состояния, в которых правило ошибается</translation>
        </message>
        <message>
            <source>path back along m*</source>
            <translation>обратный ход по m*</translation>
        </message>
        <message>
            <source>proven quickest cycle</source>
            <translation>доказанный кратчайший цикл</translation>
        </message>
        <message>
            <source>the rule is wrong here</source>
            <translation>здесь правило ошибается</translation>
        </message>
        <message>
            <source>no admissible move</source>
            <translation>нет допустимого хода</translation>
        </message>
        <message>
            <source>moves into the state (× struck out)</source>
            <translation>ходы в состояние (× вычеркнут)</translation>
        </message>
        <message>
            <source>m: radial feed, mm/dbl stroke
axial feed, mm/min</source>
            <translation>m: радиальная подача, мм/дв. ход
продольная подача, мм/мин</translation>
        </message>
        <message>
            <source>m: radial feed, mm/min</source>
            <translation>m: радиальная подача, мм/мин</translation>
        </message>
    </context>
    <context>
        <name>StartingCycle</name>
        <message>
            <source>the wheel drive&apos;s power</source>
            <translation>мощность привода круга</translation>
        </message>
        <message>
            <source>the deflection of machine and part</source>
            <translation>отжатие станка и детали</translation>
        </message>
        <message>
            <source>the depth of the burnt layer</source>
            <translation>глубина прижога</translation>
        </message>
        <message>
            <source>the machine&apos;s highest feed</source>
            <translation>наибольшая подача станка</translation>
        </message>
        <message>
            <source>the usual depth of cut</source>
            <translation>обычная глубина резания</translation>
        </message>
    </context>
    <context>
        <name>StateGridSheet</name>
        <message>
            <source>State</source>
            <translation>Состояние</translation>
        </message>
        <message>
            <source>Stock left, mm</source>
            <translation>Осталось припуска, мм</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>Подача</translation>
        </message>
        <message>
            <source>Moves struck out</source>
            <translation>Вычеркнутые ходы</translation>
        </message>
        <message>
            <source>States in which the rule is wrong</source>
            <translation>Состояния, в которых правило ошибается</translation>
        </message>
        <message>
            <source>A cell [n, m] holds the minimum time T[n,m] in which n levels of stock are removed, the last with feed m, and m*, the feed before it: T[n,m] = min over m&apos; of (T[n−1,m&apos;] + τ), T[0,0] = 0, over the moves that break no requirement. The minimum time of the last level is that of the cycle; its feeds are read back along m*.</source>
            <translation>В клетке [n, m] записаны наименьшее время T[n,m], за которое снимаются n уровней припуска, последний с подачей m, и m* — номер подачи перед ним: T[n,m] = min по m&apos; (T[n−1,m&apos;] + τ), T[0,0] = 0, по ходам, не нарушающим требований. Наименьшее время последнего уровня — время цикла; его подачи читаются обратным ходом по m*.</translation>
        </message>
        <message>
            <source>The grid of dynamic programming: T, %1, and m*</source>
            <translation>Координатная сетка динамического программирования: T, %1, и m*</translation>
        </message>
    </context>
    <context>
        <name>StateGridText</name>
        <message>
            <source>Proving: %1</source>
            <translation>Доказательство: %1</translation>
        </message>
        <message>
            <source>Level %1 of %2</source>
            <translation>Уровень %1 из %2</translation>
        </message>
        <message>
            <source>The search lists no feeds for this grid. Add them on the page Search.</source>
            <translation>В поиске нет подач для этой сетки. Добавьте их на странице «Поиск».</translation>
        </message>
        <message>
            <source>The levels of stock are gauged: the grid covers cycles under gauge control. This project is under position control; the page Gauge changes that.</source>
            <translation>Уровни припуска контролирует прибор: сетка состоит из циклов с управлением от прибора. В этом проекте управление по положению; оно меняется на странице «ПАК».</translation>
        </message>
        <message>
            <source>Levels: %1, feeds: %2, stages at most: %3</source>
            <translation>Уровней: %1, подач: %2, ступеней не более: %3</translation>
        </message>
        <message>
            <source>Published rule: %1; stages %2.</source>
            <translation>Опубликованное правило: %1; ступени %2.</translation>
        </message>
        <message>
            <source>The published rule finds no cycle: no move into the last level is admissible.</source>
            <translation>Опубликованное правило не находит цикла: ни один ход на последний уровень не допустим.</translation>
        </message>
        <message>
            <source>more than 9·10¹⁸</source>
            <translation>более 9·10¹⁸</translation>
        </message>
        <message>
            <source>Proved: none of the %1 cycles of the grid meets every requirement.</source>
            <translation>Доказано: ни один из циклов сетки (%1) не выполняет всех требований.</translation>
        </message>
        <message>
            <source>Proven quickest of the %1 cycles of the grid: %2; stages %3.</source>
            <translation>Доказанный кратчайший из циклов сетки (%1): %2; ступени %3.</translation>
        </message>
        <message>
            <source>none of the %1 cycles is below %2</source>
            <translation>ни один из циклов (%1) не короче %2</translation>
        </message>
        <message>
            <source>The proof was stopped: best so far %1, %2.</source>
            <translation>Доказательство прервано: лучший пока %1, %2.</translation>
        </message>
        <message>
            <source>The proof was stopped: no cycle found so far, %1.</source>
            <translation>Доказательство прервано: цикл пока не найден, %1.</translation>
        </message>
        <message>
            <source>struck out, although the proven cycle reaches it after %1</source>
            <translation>вычеркнуто, хотя доказанный цикл достигает его через %1</translation>
        </message>
        <message>
            <source>its time is not the least: the proven cycle reaches it after %1</source>
            <translation>его время не наименьшее: доказанный цикл достигает его через %1</translation>
        </message>
        <message>
            <source>the kept path is the wrong one to continue: the proven cycle reaches the state after %1 and continues; the kept path, with the same feeds from here on, %2</source>
            <translation>запомнен не тот путь, который следует продолжать: доказанный цикл достигает состояния через %1 и продолжается; запомненный путь с теми же дальнейшими подачами %2</translation>
        </message>
        <message>
            <source>does not reach the size</source>
            <translation>не достигает размера</translation>
        </message>
        <message>
            <source>breaks: %1</source>
            <translation>нарушает: %1</translation>
        </message>
        <message numerus="yes">
            <source>takes %1 in %n stage(s)</source>
            <translation>
                <numerusform>длится %1 за %n ступень</numerusform>
                <numerusform>длится %1 за %n ступени</numerusform>
                <numerusform>длится %1 за %n ступеней</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>The rule fails in %n state(s), first in %1: %2.</source>
            <translation>
                <numerusform>Правило ошибается в %n состоянии, впервые в %1: %2.</numerusform>
                <numerusform>Правило ошибается в %n состояниях, впервые в %1: %2.</numerusform>
                <numerusform>Правило ошибается в %n состояниях, впервые в %1: %2.</numerusform>
            </translation>
        </message>
        <message>
            <source>The rule is right on this grid.</source>
            <translation>На этой сетке правило верно.</translation>
        </message>
        <message>
            <source>The rule is right: there is no cycle to find.</source>
            <translation>Правило верно: искать нечего.</translation>
        </message>
        <message>
            <source>too many stages</source>
            <translation>слишком много ступеней</translation>
        </message>
        <message>
            <source>feed rises</source>
            <translation>подача растёт</translation>
        </message>
        <message>
            <source>level not reached</source>
            <translation>уровень не достигнут</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <comment>a cause and how many moves</comment>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>no admissible move</source>
            <translation>нет допустимого хода</translation>
        </message>
        <message>
            <source>T = %1 %2, from the blank</source>
            <translation>T = %1 %2, от заготовки</translation>
        </message>
        <message>
            <source>T = %1 %2 = %3 + %4, m* = %5</source>
            <translation>T = %1 %2 = %3 + %4, m* = %5</translation>
        </message>
        <message>
            <source>; not quicker: %1</source>
            <translation>; не быстрее: %1</translation>
        </message>
        <message>
            <source>; struck out: %1</source>
            <translation>; вычеркнуто: %1</translation>
        </message>
        <message>
            <source>The blank: T[0, 0] = 0. Nothing is filled yet.</source>
            <translation>Заготовка: T[0, 0] = 0. Ещё ничего не заполнено.</translation>
        </message>
        <message>
            <source>State %1: %2 mm left, feed %3</source>
            <translation>Состояние %1: осталось %2 мм, подача %3</translation>
        </message>
        <message>
            <source>Backtracking. %1</source>
            <translation>Обратный ход. %1</translation>
        </message>
    </context>
    <context>
        <name>StepFormulas</name>
        <message>
            <source>%1, eq. %2</source>
            <comment>key of a source, its equation</comment>
            <translation>%1, ф. %2</translation>
        </message>
        <message>
            <source>Source: %1</source>
            <translation>Источник: %1</translation>
        </message>
        <message>
            <source>Symbol</source>
            <translation>Обозначение</translation>
        </message>
        <message>
            <source>Meaning</source>
            <translation>Величина</translation>
        </message>
    </context>
    <context>
        <name>HandoutTask</name>
        <message>
            <source>Course</source>
            <translation>Курс</translation>
        </message>
        <message>
            <source>Project file</source>
            <translation>Файл проекта</translation>
        </message>
        <message>
            <source>A shaft of %1 is ground over a length of %2 mm. Its blank has at least %3 mm of stock per side and a runout of %4 mm.</source>
            <translation>Шлифуется вал %1 на длине %2 мм. Припуск заготовки — не менее %3 мм на сторону, её радиальное биение — %4 мм.</translation>
        </message>
        <message>
            <source>A bore of %1 is ground over a length of %2 mm. Its blank has at least %3 mm of stock per side and a runout of %4 mm.</source>
            <translation>Шлифуется отверстие %1 на длине %2 мм. Припуск заготовки — не менее %3 мм на сторону, её радиальное биение — %4 мм.</translation>
        </message>
        <message>
            <source>By the model the cycle takes %1. Follow one step of it, formula by formula, and find what limits the feed there.</source>
            <translation>По модели цикл длится %1. Проследите один его шаг формула за формулой и найдите, что ограничивает там подачу.</translation>
        </message>
        <message>
            <source>Symbol</source>
            <translation>Обозначение</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Meaning</source>
            <translation>Величина</translation>
        </message>
        <message>
            <source>Source</source>
            <translation>Источник</translation>
        </message>
        <message>
            <source>Compliance of the system, %1</source>
            <translation>Податливость технологической системы, %1</translation>
        </message>
    </context>
    <context>
        <name>HandoutFigures</name>
        <message>
            <source>Feeds in double stroke %1; the line marks the step</source>
            <translation>Подачи за двойной ход %1; линия отмечает разобранный шаг</translation>
        </message>
        <message>
            <source>Feeds around revolution %1; the line marks the step</source>
            <translation>Подачи около оборота %1; линия отмечает разобранный шаг</translation>
        </message>
    </context>
    <context>
        <name>ExerciseSheet</name>
        <message>
            <source>Computed by the engine, which ran the whole cycle with only that input changed.</source>
            <translation>Ответы вычислены программой: весь цикл просчитан с одной изменённой исходной величиной.</translation>
        </message>
        <message>
            <source>Asked for</source>
            <translation>Что найти</translation>
        </message>
        <message>
            <source>Before</source>
            <translation>Было</translation>
        </message>
        <message>
            <source>Changed</source>
            <translation>Стало</translation>
        </message>
        <message>
            <source>Difference, %</source>
            <translation>Изменение, %</translation>
        </message>
    </context>
    <context>
        <name>Citations</name>
        <message>
            <source>Key</source>
            <translation>Ключ</translation>
        </message>
        <message>
            <source>Source</source>
            <translation>Источник</translation>
        </message>
    </context>
    <context>
        <name>CycleCard</name>
        <message>
            <source>Prediction</source>
            <translation>Прогноз</translation>
        </message>
        <message>
            <source>Machining time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>From the headstock end, mm</source>
            <translation>От конца у передней бабки, мм</translation>
        </message>
        <message>
            <source>Minimum deviation, µm</source>
            <translation>Наименьшее отклонение, мкм</translation>
        </message>
        <message>
            <source>Maximum deviation, µm</source>
            <translation>Наибольшее отклонение, мкм</translation>
        </message>
        <message>
            <source>Radial runout, µm</source>
            <translation>Радиальное биение, мкм</translation>
        </message>
        <message>
            <source>Roundness, µm</source>
            <translation>Отклонение от круглости, мкм</translation>
        </message>
        <message>
            <source>Requirement</source>
            <translation>Требование</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>Предел</translation>
        </message>
        <message>
            <source>Margin</source>
            <translation>Запас</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>Cycle card of a grinding operation</source>
            <translation>Карта цикла шлифования</translation>
        </message>
        <message>
            <source>Tooling and settings</source>
            <translation>Оснастка и режимы</translation>
        </message>
        <message>
            <source>Settings by stage</source>
            <translation>Режимы по ступеням</translation>
        </message>
        <message>
            <source>Predicted accuracy</source>
            <translation>Ожидаемая точность</translation>
        </message>
        <message>
            <source>Requirements and margins</source>
            <translation>Требования и запасы</translation>
        </message>
        <message>
            <source>Course of the cycle</source>
            <translation>Ход цикла</translation>
        </message>
        <message>
            <source>Values based on estimates</source>
            <translation>Что опирается на оценки</translation>
        </message>
        <message>
            <source>Remarks</source>
            <translation>Замечания</translation>
        </message>
        <message>
            <source>Notes</source>
            <translation>Примечания</translation>
        </message>
        <message>
            <source>The numbers are predictions of a model and are to be confirmed at the machine. The card follows the layout of an operation card and claims no conformity with the form of any standard.</source>
            <translation>Числа предсказаны моделью и подлежат проверке на станке. Карта составлена по образцу операционной карты и не претендует на соответствие форме какого-либо стандарта.</translation>
        </message>
        <message>
            <source>Zone</source>
            <translation>Зона</translation>
        </message>
        <message>
            <source>Cylindricity, µm</source>
            <translation>Отклонение от цилиндричности, мкм</translation>
        </message>
        <message>
            <source>Total runout, µm</source>
            <translation>Полное радиальное биение, мкм</translation>
        </message>
        <message>
            <source>Taper, µm</source>
            <translation>Конусообразность, мкм</translation>
        </message>
        <message>
            <source>Crown, µm</source>
            <translation>Бочкообразность, мкм</translation>
        </message>
        <message>
            <source>Calibrated inputs</source>
            <translation>Откалиброванные исходные данные</translation>
        </message>
    </context>
    <context>
        <name>OutcomeRemarks</name>
        <message>
            <source>These predictions rest on inputs that are estimates, to be calibrated at the machine.</source>
            <translation>Эти результаты опираются на исходные данные, которые являются оценками и подлежат калибровке на станке.</translation>
        </message>
        <message>
            <source>%1: with an even number of lobes the diameters are %2…%3 µm from nominal.</source>
            <translation>%1: при чётном числе граней диаметры %2…%3 мкм от номинала.</translation>
        </message>
    </context>
    <context>
        <name>OperationSetup</name>
        <message>
            <source>Work speed varied</source>
            <translation>Изменение частоты вращения заготовки</translation>
        </message>
        <message>
            <source>±%1 % in %2 s</source>
            <translation>±%1 % за %2 с</translation>
        </message>
        <message>
            <source>Cylindrical traverse grinding</source>
            <translation>Круглошлифовальная</translation>
        </message>
        <message>
            <source>Internal traverse grinding</source>
            <translation>Внутришлифовальная</translation>
        </message>
        <message>
            <source>Internal plunge grinding</source>
            <translation>Внутришлифовальная</translation>
        </message>
        <message>
            <source>Cylindrical plunge grinding</source>
            <translation>Круглошлифовальная</translation>
        </message>
        <message>
            <source>Name of the operation</source>
            <translation>Наименование операции</translation>
        </message>
        <message>
            <source>Kind of grinding</source>
            <translation>Вид шлифования</translation>
        </message>
        <message>
            <source>Part</source>
            <translation>Деталь</translation>
        </message>
        <message>
            <source>Equipment</source>
            <translation>Оборудование</translation>
        </message>
        <message>
            <source>Size by the drawing</source>
            <translation>Размер по чертежу</translation>
        </message>
        <message>
            <source>Material</source>
            <translation>Материал</translation>
        </message>
        <message>
            <source>Hardness</source>
            <translation>Твёрдость</translation>
        </message>
        <message>
            <source>Prepared by</source>
            <translation>Разработал</translation>
        </message>
        <message>
            <source>Date</source>
            <translation>Дата</translation>
        </message>
        <message>
            <source>Grinding wheel, marking</source>
            <translation>Шлифовальный круг, маркировка</translation>
        </message>
        <message>
            <source>Wheel diameter × width</source>
            <translation>Диаметр × высота круга</translation>
        </message>
        <message>
            <source>Wheel rotation</source>
            <translation>Частота вращения круга</translation>
        </message>
        <message>
            <source>Work surface speed</source>
            <translation>Окружная скорость детали</translation>
        </message>
        <message>
            <source>%1 m/min</source>
            <translation>%1 м/мин</translation>
        </message>
        <message>
            <source>by the position of the wheel head</source>
            <translation>по положению шлифовальной бабки</translation>
        </message>
        <message>
            <source>in-process gauge: %1, %2 from the headstock end of the ground length</source>
            <translation>прибор активного контроля: %1, %2 от конца шлифуемой длины у передней бабки</translation>
        </message>
        <message>
            <source>Size control</source>
            <translation>Управление размером</translation>
        </message>
        <message>
            <source>Stage</source>
            <translation>Ступень</translation>
        </message>
        <message>
            <source>Radial feed, mm/min</source>
            <translation>Радиальная подача, мм/мин</translation>
        </message>
        <message>
            <source>Radial feed, mm/dbl stroke</source>
            <translation>Подача радиальная, мм/дв. ход</translation>
        </message>
        <message>
            <source>Axial feed, mm/min</source>
            <translation>Продольная подача, мм/мин</translation>
        </message>
        <message>
            <source>Continuous infeed, mm/min</source>
            <translation>Подача непрерывная, мм/мин</translation>
        </message>
        <message>
            <source>Stock per side, mm</source>
            <translation>Припуск на сторону, мм</translation>
        </message>
        <message>
            <source>Double strokes</source>
            <translation>Двойные ходы</translation>
        </message>
        <message>
            <source>Revolutions</source>
            <translation>Обороты</translation>
        </message>
        <message>
            <source>Machining time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>Spark-out</source>
            <translation>Выхаживание</translation>
        </message>
        <message>
            <source>Maximum power, kW</source>
            <translation>Мощность наибольшая, кВт</translation>
        </message>
        <message>
            <source>Maximum force Py, N</source>
            <translation>Сила Py наибольшая, Н</translation>
        </message>
        <message>
            <source>until size</source>
            <translation>до размера</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Цикл</translation>
        </message>
        <message>
            <source>Coolant</source>
            <translation>СОЖ</translation>
        </message>
        <message>
            <source>Dressing</source>
            <translation>Правка круга</translation>
        </message>
        <message>
            <source>Interrupted surface</source>
            <translation>Прерывистая поверхность</translation>
        </message>
        <message numerus="yes">
            <source>%n gap(s), %1 % of the turn is ground</source>
            <translation>
                <numerusform>%n паз, шлифуется %1 % оборота</numerusform>
                <numerusform>%n паза, шлифуется %1 % оборота</numerusform>
                <numerusform>%n пазов, шлифуется %1 % оборота</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>Default</name>
        <message>
            <source>yes</source>
            <translation>да</translation>
        </message>
        <message>
            <source>no</source>
            <translation>нет</translation>
        </message>
    </context>
    <context>
        <name>Edit</name>
        <message>
            <source>Add a stage</source>
            <translation>Добавить ступень</translation>
        </message>
        <message>
            <source>Remove a stage</source>
            <translation>Удаление ступени</translation>
        </message>
        <message>
            <source>Continuous infeed</source>
            <translation>Непрерывная радиальная подача</translation>
        </message>
        <message>
            <source>Move a stage</source>
            <translation>Перестановка ступеней</translation>
        </message>
        <message>
            <source>Reload the file</source>
            <translation>Перезагрузка файла</translation>
        </message>
        <message>
            <source>Put the gauge in the best place</source>
            <translation>Прибор в лучшее место</translation>
        </message>
        <message>
            <source>Material from the catalogue</source>
            <translation>Материал из каталога</translation>
        </message>
        <message>
            <source>Wheel from the catalogue</source>
            <translation>Круг из каталога</translation>
        </message>
        <message>
            <source>Machine from the catalogue</source>
            <translation>Станок из каталога</translation>
        </message>
        <message>
            <source>Wheel from its marking</source>
            <translation>Круг по маркировке</translation>
        </message>
        <message>
            <source>Limits from the tolerance class</source>
            <translation>Отклонения по полю допуска</translation>
        </message>
        <message>
            <source>Add a batch</source>
            <translation>Добавить партию</translation>
        </message>
        <message>
            <source>Keep the current run</source>
            <translation>Запомнить текущий расчёт</translation>
        </message>
        <message>
            <source>Rename a kept run</source>
            <translation>Переименовать запомненный расчёт</translation>
        </message>
        <message>
            <source>Delete a kept run</source>
            <translation>Удалить запомненный расчёт</translation>
        </message>
        <message>
            <source>Restore the inputs of a kept run</source>
            <translation>Вернуть исходные данные запомненного расчёта</translation>
        </message>
        <message>
            <source>Add a search</source>
            <translation>Добавить поиск</translation>
        </message>
        <message>
            <source>Apply the cycle found</source>
            <translation>Применить найденный цикл</translation>
        </message>
        <message>
            <source>Apply the values of a point of the sweep</source>
            <translation>Применить значения точки варьирования</translation>
        </message>
        <message>
            <source>Input of the sweep</source>
            <translation>Варьируемая величина</translation>
        </message>
        <message>
            <source>Range of the sweep</source>
            <translation>Пределы варьирования</translation>
        </message>
        <message>
            <source>Paste</source>
            <translation>Вставить</translation>
        </message>
        <message>
            <source>Fit the stocks of the stages</source>
            <translation>Согласовать припуски ступеней</translation>
        </message>
        <message>
            <source>Add a surface</source>
            <translation>Добавление поверхности</translation>
        </message>
        <message>
            <source>Duplicate a surface</source>
            <translation>Копия поверхности</translation>
        </message>
        <message>
            <source>Rename a surface</source>
            <translation>Переименование поверхности</translation>
        </message>
        <message>
            <source>Remove a surface</source>
            <translation>Удаление поверхности</translation>
        </message>
        <message>
            <source>Move a surface</source>
            <translation>Перестановка поверхности</translation>
        </message>
        <message>
            <source>Standard times</source>
            <translation>Нормы времени</translation>
        </message>
        <message>
            <source>Wheel wear</source>
            <translation>Износ круга</translation>
        </message>
        <message>
            <source>Apply the cycles found</source>
            <translation>Применить найденные циклы</translation>
        </message>
        <message>
            <source>Calibrate from measurements</source>
            <translation>Калибровка по измерениям</translation>
        </message>
        <message>
            <source>Import measurements</source>
            <translation>Импорт измерений</translation>
        </message>
        <message>
            <source>Mass from the steps of the shaft</source>
            <translation>Масса по ступеням вала</translation>
        </message>
        <message>
            <source>Machine&apos;s form from the measured parts</source>
            <translation>Форма от станка по измеренным деталям</translation>
        </message>
        <message>
            <source>Add a spark-out</source>
            <translation>Добавление выхаживания</translation>
        </message>
        <message>
            <source>Starting cycle</source>
            <translation>Исходный цикл</translation>
        </message>
        <message>
            <source>Gap from a keyway</source>
            <translation>Паз по шпоночному пазу</translation>
        </message>
    </context>
    <context>
        <name>EstimateNames</name>
        <message>
            <source>Based on estimates, to be calibrated: %1.</source>
            <translation>Опирается на оценки, подлежащие калибровке: %1.</translation>
        </message>
    </context>
    <context>
        <name>Example</name>
        <message>
            <source>Bearing seat 35k6, starting cycle</source>
            <translation>Посадочная шейка 35k6, исходный цикл</translation>
        </message>
        <message>
            <source>Bearing seat 35k6</source>
            <translation>Посадочная шейка 35k6</translation>
        </message>
        <message>
            <source>Bore 40H7, plunge with spark-out</source>
            <translation>Отверстие 40H7, врезание с выхаживанием</translation>
        </message>
        <message>
            <source>Shaft with four sections, two-stage plunge</source>
            <translation>Вал из четырёх сечений, двухступенчатое врезание</translation>
        </message>
        <message>
            <source>Shaft 30h6, factory cycle</source>
            <translation>Вал 30h6, заводской цикл</translation>
        </message>
        <message>
            <source>Shaft 30h6, optimal cycle</source>
            <translation>Вал 30h6, оптимальный цикл</translation>
        </message>
        <message>
            <source>Shaft 38.74h6, factory cycle</source>
            <translation>Вал 38,74h6, заводской цикл</translation>
        </message>
        <message>
            <source>Waves that no spark-out removes</source>
            <translation>Волны, которых не убирает выхаживание</translation>
        </message>
        <message>
            <source>Seventy waves counted on a roll</source>
            <translation>Семьдесят волн на валике</translation>
        </message>
        <message>
            <source>Roll 160h6</source>
            <translation>Валик 160h6</translation>
        </message>
        <message>
            <source>Slender shaft with a soft middle</source>
            <translation>Нежёсткий вал с податливой серединой</translation>
        </message>
        <message>
            <source>Spark-out until size</source>
            <translation>Выхаживание до размера</translation>
        </message>
        <message>
            <source>Dull wheel</source>
            <translation>Затупившийся круг</translation>
        </message>
        <message>
            <source>Freshly dressed wheel</source>
            <translation>Только что правленый круг</translation>
        </message>
        <message>
            <source>Factory</source>
            <translation>Заводской</translation>
        </message>
        <message>
            <source>Factory, 92 mm</source>
            <translation>Заводской, 92 мм</translation>
        </message>
        <message>
            <source>Optimal</source>
            <translation>Оптимальный</translation>
        </message>
        <message>
            <source>Spindle of five surfaces</source>
            <translation>Шпиндель с пятью поверхностями</translation>
        </message>
        <message>
            <source>Bushing with a bore, internal traverse</source>
            <translation>Втулка 50H7, внутреннее шлифование с продольной подачей</translation>
        </message>
        <message>
            <source>Shaft 30h6, measured batch of 50</source>
            <translation>Вал 30h6, измеренная партия из 50</translation>
        </message>
        <message>
            <source>Shaft 30h6, tables 2 and 3 calibrated</source>
            <translation>Вал 30h6, калибровка по таблицам 2 и 3</translation>
        </message>
        <message>
            <source>Shaft 30h6, table 2 by a computed compliance</source>
            <translation>Вал 30h6, таблица 2 при вычисленной податливости</translation>
        </message>
        <message>
            <source>Roughness binds the last cut</source>
            <translation>Последний срез ограничен шероховатостью</translation>
        </message>
        <message>
            <source>Self-sharpening binds the first stage</source>
            <translation>Первая ступень ограничена самозатачиванием</translation>
        </message>
        <message>
            <source>Accuracy binds the last feed</source>
            <translation>Последняя подача ограничена точностью</translation>
        </message>
        <message>
            <source>Bore 40H7</source>
            <translation>Отверстие 40H7</translation>
        </message>
        <message>
            <source>Shaft 40k6</source>
            <translation>Вал 40k6</translation>
        </message>
        <message>
            <source>Shaft 30h6</source>
            <translation>Вал 30h6</translation>
        </message>
        <message>
            <source>Shaft 38.74h6</source>
            <translation>Вал 38,74h6</translation>
        </message>
        <message>
            <source>Shaft 25h6</source>
            <translation>Вал 25h6</translation>
        </message>
        <message>
            <source>Shaft 50h6</source>
            <translation>Вал 50h6</translation>
        </message>
        <message>
            <source>Bushing 50H7</source>
            <translation>Втулка 50H7</translation>
        </message>
        <message>
            <source>Spindle</source>
            <translation>Шпиндель</translation>
        </message>
        <message>
            <source>Journal 35h6 A</source>
            <translation>Шейка 35h6 А</translation>
        </message>
        <message>
            <source>Bearing seat 40k6 B</source>
            <translation>Посадочная шейка 40k6 Б</translation>
        </message>
        <message>
            <source>Bearing seat 40k6 C</source>
            <translation>Посадочная шейка 40k6 В</translation>
        </message>
        <message>
            <source>Journal 35h7 D</source>
            <translation>Шейка 35h7 Г</translation>
        </message>
        <message>
            <source>Coupling seat 30n6 E</source>
            <translation>Шейка под муфту 30n6 Д</translation>
        </message>
    </context>
    <context>
        <name>Exercises</name>
        <message>
            <source>The wheel has become dull: η rises from %1 to %2.</source>
            <translation>Круг затупился: η выросла с %1 до %2.</translation>
        </message>
        <message>
            <source>less is cut at the same lag</source>
            <translation>при том же отставании срезается меньше</translation>
        </message>
        <message>
            <source>the friction of the wear flats, kr·√a, grows with η</source>
            <translation>трение площадок износа kr·√a растёт вместе с η</translation>
        </message>
        <message>
            <source>The technological system is %1 times as compliant in every zone.</source>
            <translation>Технологическая система во всех зонах податливее в %1 раза.</translation>
        </message>
        <message>
            <source>The technological system is %1 times as compliant in every section.</source>
            <translation>Технологическая система во всех сечениях податливее в %1 раза.</translation>
        </message>
        <message>
            <source>a place differs in diameter from the one with the gauge by twice the difference of their deflections γ·Py at the end</source>
            <translation>диаметр отличается от диаметра под прибором активного контроля на удвоенную разность упругих отжатий γ·Py в конце цикла</translation>
        </message>
        <message>
            <source>the lag takes longer to build up, and the stage is over before the force of its feed is reached</source>
            <translation>отставание нарастает дольше, и ступень заканчивается раньше, чем сила достигает значения, соответствующего её подаче</translation>
        </message>
        <message>
            <source>The units of the machine yield %1 times as much under the same force.</source>
            <translation>Узлы станка отжимаются той же силой в %1 раза больше.</translation>
        </message>
        <message>
            <source>the force at the end is that of a smaller feed, so the deflections differ less from place to place</source>
            <translation>в конце цикла сила соответствует меньшей подаче, поэтому отжатия меньше различаются по длине</translation>
        </message>
        <message>
            <source>less of it remains after more and shallower cuts</source>
            <translation>после большего числа менее глубоких проходов от него остаётся меньше</translation>
        </message>
        <message>
            <source>the last revolution leaves a step as deep as its cut, which is shallower now</source>
            <translation>последний оборот оставляет уступ, равный глубине среза, а она стала меньше</translation>
        </message>
        <message>
            <source>The radial feed of stage %1 is halved, from %2 to %3.</source>
            <translation>Радиальная подача ступени %1 уменьшена вдвое, с %2 до %3.</translation>
        </message>
        <message>
            <source>The blanks come with twice the runout, %1 instead of %2.</source>
            <translation>Биение заготовок вдвое больше: %1 вместо %2.</translation>
        </message>
        <message>
            <source>high places are cut deeper than low ones, but not deep enough to remove all of the added %1</source>
            <translation>выступающие места срезаются глубже впадин, но не настолько, чтобы от прибавленных %1 ничего не осталось</translation>
        </message>
        <message>
            <source>the stock is the minimum over all radii, so a larger runout means more metal to remove</source>
            <translation>припуск — наименьший из припусков всех радиусов, поэтому с большим биением снимается больше металла</translation>
        </message>
        <message>
            <source>the first stage has more metal to remove</source>
            <translation>первая ступень снимает больше металла</translation>
        </message>
        <message>
            <source>The stock is larger by a fifth: %1 instead of %2 per side, and the first stage removes the rest.</source>
            <translation>Припуск больше на пятую часть: %1 вместо %2 на сторону, прибавку снимает первая ступень.</translation>
        </message>
        <message>
            <source>The step is at the place and the radius worked out above.</source>
            <translation>Шаг — в том же месте и на том же радиусе, что разобраны выше.</translation>
        </message>
        <message>
            <source>The step is at the place and the radius worked out above; take double stroke %1, which both cycles have.</source>
            <translation>Шаг — в том же месте и на том же радиусе, что разобраны выше; возьмите двойной ход %1: он есть в обоих циклах.</translation>
        </message>
        <message>
            <source>The step is at the place and the radius worked out above; take revolution %1, which both cycles have.</source>
            <translation>Шаг — в том же месте и на том же радиусе, что разобраны выше; возьмите оборот %1: он есть в обоих циклах.</translation>
        </message>
        <message>
            <source>Find how this changes, and why: %1.</source>
            <translation>Найдите, как изменится и почему: %1.</translation>
        </message>
        <message>
            <source>Find how these change, and why: %1.</source>
            <translation>Найдите, как изменятся и почему: %1.</translation>
        </message>
        <message>
            <source>stage %1 takes %2 longer</source>
            <translation>ступень %1 длиннее на %2</translation>
        </message>
        <message>
            <source>stage %1 takes %2 less</source>
            <translation>ступень %1 короче на %2</translation>
        </message>
        <message>
            <source>the larger lag takes longer to build up</source>
            <translation>большее отставание нарастает дольше</translation>
        </message>
        <message>
            <source>the stored deflection continues to cut in the slower stage</source>
            <translation>то, на что отжата система, срезается ещё и на более медленной ступени</translation>
        </message>
        <message>
            <source>Actual feed a of the step</source>
            <translation>Фактическая подача a шага</translation>
        </message>
        <message>
            <source>Normal force Py of the step</source>
            <translation>Нормальная сила Py шага</translation>
        </message>
        <message>
            <source>Machining time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>Number of double strokes</source>
            <translation>Число двойных ходов</translation>
        </message>
        <message>
            <source>Number of revolutions</source>
            <translation>Число оборотов</translation>
        </message>
        <message>
            <source>Maximum minus minimum diameter along the part</source>
            <translation>Разность наибольшего и наименьшего диаметров детали</translation>
        </message>
        <message>
            <source>Maximum radial runout</source>
            <translation>Наибольшее радиальное биение</translation>
        </message>
        <message>
            <source>Maximum normal force Py</source>
            <translation>Наибольшая нормальная сила Py</translation>
        </message>
        <message>
            <source>Maximum power</source>
            <translation>Наибольшая мощность</translation>
        </message>
        <message>
            <source>%1 rises</source>
            <translation>%1 растёт</translation>
        </message>
        <message>
            <source>%1 falls</source>
            <translation>%1 уменьшается</translation>
        </message>
    </context>
    <context>
        <name>ExportFile</name>
        <message>
            <source>JSON files (*.json)</source>
            <translation>Файлы JSON (*.json)</translation>
        </message>
        <message>
            <source>There is no trace: the run has %1 rows and a trace at most %2, so only the results are kept.</source>
            <translation>Трассы нет: в ней было бы %1 строк, а записывается не больше %2. Результаты сохранены полностью.</translation>
        </message>
    </context>
    <context>
        <name>FactorLines</name>
        <message>
            <source>Minimum</source>
            <translation>Наименьшее</translation>
        </message>
        <message>
            <source>Maximum</source>
            <translation>Наибольшее</translation>
        </message>
        <message>
            <source>Mean</source>
            <translation>Среднее</translation>
        </message>
        <message>
            <source>Standard deviation</source>
            <translation>Стандартное отклонение</translation>
        </message>
        <message>
            <source>Most frequent</source>
            <translation>Наиболее частое</translation>
        </message>
        <message>
            <source>First part</source>
            <translation>Первая деталь</translation>
        </message>
        <message>
            <source>Last part</source>
            <translation>Последняя деталь</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Empty: %1.</source>
            <translation>Пусто: %1.</translation>
        </message>
        <message>
            <source>Allowed: %1.</source>
            <translation>Допускается: %1.</translation>
        </message>
    </context>
    <context>
        <name>FeedText</name>
        <message>
            <source>programmed feed</source>
            <translation>программная подача</translation>
        </message>
        <message>
            <source>actual feed</source>
            <translation>фактическая подача</translation>
        </message>
        <message>
            <source>accumulated programmed feed</source>
            <translation>накопленная программная подача</translation>
        </message>
        <message>
            <source>accumulated actual feed</source>
            <translation>накопленная фактическая подача</translation>
        </message>
        <message>
            <source>radius before the pass</source>
            <translation>радиус до прохода</translation>
        </message>
        <message>
            <source>radius after the pass</source>
            <translation>радиус после прохода</translation>
        </message>
        <message>
            <source>axial feed</source>
            <translation>продольная подача</translation>
        </message>
        <message>
            <source>normal force</source>
            <translation>нормальная сила</translation>
        </message>
        <message>
            <source>pass %1</source>
            <translation>проход %1</translation>
        </message>
        <message>
            <source>radius %1</source>
            <translation>радиус %1</translation>
        </message>
        <message>
            <source>feed: programmed %1, actual %2 µm</source>
            <translation>подача: программная %1, фактическая %2 мкм</translation>
        </message>
        <message>
            <source>radius before %1, after %2 µm</source>
            <translation>радиус до %1, после %2 мкм</translation>
        </message>
        <message>
            <source>force %1 N</source>
            <translation>сила %1 Н</translation>
        </message>
        <message>
            <source>axial feed %1 mm/min</source>
            <translation>продольная подача %1 мм/мин</translation>
        </message>
        <message>
            <source>%1, mm/min</source>
            <translation>%1, мм/мин</translation>
        </message>
        <message>
            <source>%1, N</source>
            <translation>%1, Н</translation>
        </message>
        <message>
            <source>%1, µm</source>
            <translation>%1, мкм</translation>
        </message>
        <message>
            <source>accumulated: programmed %1, actual %2 µm</source>
            <translation>накопленные: программная %1, фактическая %2 мкм</translation>
        </message>
    </context>
    <context>
        <name>FieldText</name>
        <message>
            <source>%1…%2 in steps of %3</source>
            <translation>%1…%2 с шагом %3</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>да</translation>
        </message>
        <message>
            <source>no</source>
            <translation>нет</translation>
        </message>
    </context>
    <context>
        <name>FileDialog</name>
        <message>
            <source>Folder</source>
            <translation>Папка</translation>
        </message>
        <message>
            <source>%1 kB</source>
            <translation>%1 кБ</translation>
        </message>
    </context>
    <context>
        <name>FileError</name>
        <message>
            <source>the file or folder is not accessible</source>
            <translation>файл или папка недоступны</translation>
        </message>
        <message>
            <source>the path does not name a file</source>
            <translation>по этому пути находится не файл</translation>
        </message>
        <message>
            <source>the file is read-only</source>
            <translation>файл доступен только для чтения</translation>
        </message>
        <message>
            <source>it cannot be opened</source>
            <translation>не удаётся открыть</translation>
        </message>
        <message>
            <source>no file can be created in the folder</source>
            <translation>в папке нельзя создать файл</translation>
        </message>
        <message>
            <source>its permissions cannot be set</source>
            <translation>не удаётся задать права доступа</translation>
        </message>
        <message>
            <source>the data could not be written</source>
            <translation>данные не удалось записать</translation>
        </message>
        <message>
            <source>the previous version cannot be kept</source>
            <translation>не удаётся сохранить прежнюю версию</translation>
        </message>
        <message>
            <source>the new file cannot be put in place</source>
            <translation>не удаётся поставить новый файл на место</translation>
        </message>
        <message>
            <source>the data read back from the disk differ from the data written</source>
            <translation>диск вернул не те данные, что были записаны</translation>
        </message>
        <message>
            <source>it cannot be read</source>
            <translation>не удаётся прочитать</translation>
        </message>
        <message>
            <source>the file is too large</source>
            <translation>файл слишком велик</translation>
        </message>
        <message>
            <source>another program has changed it in the meantime</source>
            <translation>за это время его изменила другая программа</translation>
        </message>
        <message>
            <source>this program could not read the saved content back</source>
            <translation>такое содержимое эта программа не смогла бы прочитать снова</translation>
        </message>
        <message>
            <source>%1 (%2)</source>
            <translation>%1 (%2)</translation>
        </message>
        <message>
            <source>%1; free space: %2</source>
            <translation>%1; свободно: %2</translation>
        </message>
        <message>
            <source>“%1” was not opened: %2.</source>
            <translation>Файл «%1» не открыт: %2.</translation>
        </message>
        <message>
            <source>“%1” was written, but the disk did not confirm it: %2. Save again, or to another disk.</source>
            <translation>Файл «%1» записан, но диск этого не подтвердил: %2. Сохраните ещё раз или на другой диск.</translation>
        </message>
        <message>
            <source>“%1” was not saved: %2. Nothing on the disk was changed.</source>
            <translation>Файл «%1» не сохранён: %2. На диске ничего не изменилось.</translation>
        </message>
    </context>
    <context>
        <name>FileQuestion</name>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>“%1” has never been saved. Save it?</source>
            <translation>«%1» ещё ни разу не сохранён. Сохранить?</translation>
        </message>
        <message>
            <source>Untitled</source>
            <translation>Без имени</translation>
        </message>
        <message>
            <source>Save the changes to “%1”?</source>
            <translation>Сохранить изменения в «%1»?</translation>
        </message>
        <message>
            <source>Not saved:</source>
            <translation>Не сохранено:</translation>
        </message>
        <message numerus="yes">
            <source>%n more</source>
            <translation>
                <numerusform>и ещё %n правка</numerusform>
                <numerusform>и ещё %n правки</numerusform>
                <numerusform>и ещё %n правок</numerusform>
            </translation>
        </message>
        <message>
            <source>C&amp;lose</source>
            <translation>&amp;Закрыть</translation>
        </message>
        <message>
            <source>Replace the file?</source>
            <translation>Заменить файл?</translation>
        </message>
        <message>
            <source>“%1” exists already. Replace it?</source>
            <translation>«%1» уже существует. Заменить его?</translation>
        </message>
        <message>
            <source>&amp;Replace</source>
            <translation>&amp;Заменить</translation>
        </message>
        <message>
            <source>Unsaved changes</source>
            <translation>Несохранённые изменения</translation>
        </message>
        <message>
            <source>&amp;Save as…</source>
            <translation>&amp;Сохранить как…</translation>
        </message>
        <message>
            <source>&amp;Save</source>
            <translation>&amp;Сохранить</translation>
        </message>
        <message>
            <source>&amp;Do not save</source>
            <translation>&amp;Не сохранять</translation>
        </message>
        <message>
            <source>The lock file beside it cannot be read; it belongs to the user %1 and dates from %2.</source>
            <translation>Файл блокировки рядом с ним не читается; его владелец — %1, время — %2.</translation>
        </message>
        <message>
            <source>User: %1
Computer: %2
Program: %3, process %4
Since: %5</source>
            <translation>Пользователь: %1
Компьютер: %2
Программа: %3, процесс %4
Открыт: %5</translation>
        </message>
        <message>
            <source>“%1” is open already.</source>
            <translation>«%1» уже открыт.</translation>
        </message>
        <message>
            <source>“%1” seems to be open already.</source>
            <translation>«%1», по-видимому, уже открыт.</translation>
        </message>
        <message>
            <source>Open it anyway only if nobody is working in it any more.</source>
            <translation>Открывайте его, только если с ним больше никто не работает.</translation>
        </message>
        <message>
            <source>The file is in use</source>
            <translation>Файл занят</translation>
        </message>
        <message>
            <source>Open &amp;read-only</source>
            <translation>Только &amp;чтение</translation>
        </message>
        <message>
            <source>Open a co&amp;py</source>
            <translation>Открыть &amp;копию</translation>
        </message>
        <message>
            <source>&amp;Open anyway</source>
            <translation>&amp;Всё равно открыть</translation>
        </message>
        <message>
            <source>Changed outside</source>
            <translation>Файл изменён извне</translation>
        </message>
        <message>
            <source>“%1” has been removed or renamed since it was opened.</source>
            <translation>«%1» удалён или переименован после открытия.</translation>
        </message>
        <message>
            <source>“%1” was changed by another program since it was opened.

Saving replaces that version; it is kept as the previous one.
Reloading takes that version; your changes stay in Undo.</source>
            <translation>«%1» изменён другой программой после открытия.

Сохранение заменит ту версию; она останется как предыдущая.
Перезагрузка возьмёт ту версию; ваши изменения останутся в «Отменить».</translation>
        </message>
        <message>
            <source>The file is not locked against other users: “%1” has the name of its lock file but is not one. It was left unchanged.</source>
            <translation>Файл не заблокирован для других пользователей: на месте его файла блокировки стоит «%1», а это не файл блокировки. Он оставлен как есть.</translation>
        </message>
        <message>
            <source>“%1” was changed by another program since it was opened or saved.

Saving replaces that version; it is kept as the previous one.
With another name both versions stay as they are.</source>
            <translation>«%1» изменён другой программой после открытия или сохранения.

Сохранение заменит ту версию; она останется как предыдущая.
Под другим именем обе версии останутся как есть.</translation>
        </message>
        <message>
            <source>Save an&amp;yway</source>
            <translation>&amp;Всё равно сохранить</translation>
        </message>
        <message>
            <source>Save &amp;as…</source>
            <translation>Сохранить &amp;как…</translation>
        </message>
        <message>
            <source>&amp;Reload</source>
            <translation>&amp;Перезагрузить</translation>
        </message>
        <message>
            <source>“%1” is open in another window.</source>
            <translation>«%1» открыт в другом окне.</translation>
        </message>
        <message>
            <source>The file has several names</source>
            <translation>У файла несколько имён</translation>
        </message>
        <message numerus="yes">
            <source>“%1” has %n other names (hard links). They will keep the old text and no longer be the same file.</source>
            <translation>
                <numerusform>У «%1» есть ещё %n имя (жёсткая ссылка). Под ним останется прежний текст, и это будет уже другой файл.</numerusform>
                <numerusform>У «%1» есть ещё %n имени (жёсткие ссылки). Под ними останется прежний текст, и это будет уже другой файл.</numerusform>
                <numerusform>У «%1» есть ещё %n имён (жёсткие ссылки). Под ними останется прежний текст, и это будет уже другой файл.</numerusform>
            </translation>
        </message>
        <message>
            <source>The project was not saved</source>
            <translation>Проект не сохранён</translation>
        </message>
        <message>
            <source>The project in the window is unchanged and still counts as not saved.</source>
            <translation>Проект в окне не изменился и по-прежнему считается несохранённым.</translation>
        </message>
        <message>
            <source>&amp;Try again</source>
            <translation>&amp;Повторить</translation>
        </message>
        <message>
            <source>Invalid entries (not saved):</source>
            <translation>Неверные значения (не сохранены):</translation>
        </message>
        <message>
            <source>Invalid entries</source>
            <translation>Непринятый текст</translation>
        </message>
        <message>
            <source>Everything but the invalid entries is saved. Continue without them?</source>
            <translation>Всё остальное сохранено, но непринятого текста нет ни в одном файле. Продолжить без него?</translation>
        </message>
        <message>
            <source>Refused:</source>
            <translation>Не принято:</translation>
        </message>
        <message>
            <source>&amp;Continue</source>
            <translation>&amp;Продолжить</translation>
        </message>
        <message>
            <source>&amp;Back to the fields</source>
            <translation>&amp;Вернуться к полям</translation>
        </message>
    </context>
    <context>
        <name>FileSize</name>
        <message>
            <source>%1 kB</source>
            <translation>%1 кБ</translation>
        </message>
        <message>
            <source>%1 MB</source>
            <translation>%1 МБ</translation>
        </message>
        <message>
            <source>%1 GB</source>
            <translation>%1 ГБ</translation>
        </message>
    </context>
    <context>
        <name>Formula</name>
        <message>
            <source>Power of the wheel drive</source>
            <translation>Мощность привода круга</translation>
        </message>
        <message>
            <source>Power of the work drive</source>
            <translation>Мощность привода изделия</translation>
        </message>
        <message>
            <source>Limiting depth of cut, wheel drive</source>
            <translation>Предельная фактическая подача по мощности привода круга</translation>
        </message>
        <message>
            <source>Limiting depth of cut, work drive</source>
            <translation>Предельная фактическая подача по мощности привода изделия</translation>
        </message>
        <message>
            <source>Normal force</source>
            <translation>Нормальная сила</translation>
        </message>
        <message>
            <source>Tangential force</source>
            <translation>Касательная составляющая силы резания</translation>
        </message>
        <message>
            <source>Limiting depth of cut, burn</source>
            <translation>Предельная фактическая подача по прижогу</translation>
        </message>
        <message>
            <source>Elastic balance</source>
            <translation>Упругий баланс</translation>
        </message>
        <message>
            <source>Roughness</source>
            <translation>Шероховатость</translation>
        </message>
        <message>
            <source>Limiting feed, roughness</source>
            <translation>Предельная скорость подачи по шероховатости</translation>
        </message>
        <message>
            <source>Limiting depth of cut, self-sharpening</source>
            <translation>Предельная фактическая подача по самозатачиванию круга</translation>
        </message>
        <message>
            <source>Radial runout</source>
            <translation>Радиальное биение</translation>
        </message>
        <message>
            <source>Total radial runout</source>
            <translation>Полное радиальное биение</translation>
        </message>
        <message>
            <source>Roundness deviation</source>
            <translation>Отклонение от круглости</translation>
        </message>
        <message>
            <source>Cylindricity deviation</source>
            <translation>Отклонение от цилиндричности</translation>
        </message>
        <message>
            <source>Elastic balance of one radius</source>
            <translation>Упругий баланс для одного радиуса</translation>
        </message>
        <message>
            <source>In the sources K_1 = b·k_s and K_2 = b·k_r with axial feed, K_3 and K_4 in plunge.</source>
            <translation>В источниках К_1 = b·k_s и К_2 = b·k_r с продольной подачей, К_3 и К_4 — при врезании.</translation>
        </message>
        <message>
            <source>In the sources K_3 = b·k_s and K_4 = b·k_r.</source>
            <translation>В источниках К_3 = b·k_s и К_4 = b·k_r.</translation>
        </message>
    </context>
    <context>
        <name>GaugeCurves</name>
        <message>
            <source>farthest from the middle</source>
            <translation>дальше всего от середины</translation>
        </message>
        <message>
            <source>best place</source>
            <translation>лучшее место</translation>
        </message>
        <message>
            <source>current place</source>
            <translation>текущее место</translation>
        </message>
        <message>
            <source>all diameters</source>
            <translation>все диаметры</translation>
        </message>
        <message>
            <source>Gauge at, mm</source>
            <translation>Место прибора, мм</translation>
        </message>
        <message>
            <source>Compliance there, mm/N</source>
            <translation>Податливость там, мм/Н</translation>
        </message>
        <message>
            <source>Minimum diameter, µm</source>
            <translation>Наименьший диаметр, мкм</translation>
        </message>
        <message>
            <source>Maximum diameter, µm</source>
            <translation>Наибольший диаметр, мкм</translation>
        </message>
        <message>
            <source>Farthest from the middle, µm</source>
            <translation>Дальше всего от середины, мкм</translation>
        </message>
        <message>
            <source>Margin to the limits, µm</source>
            <translation>Запас до границ, мкм</translation>
        </message>
        <message>
            <source>Time, s</source>
            <translation>Время, с</translation>
        </message>
        <message>
            <source>Cycle ended by</source>
            <translation>Чем окончен цикл</translation>
        </message>
        <message>
            <source>%1, mean diameter, µm</source>
            <translation>%1, средний диаметр, мкм</translation>
        </message>
        <message>
            <source>Gauge at %1 mm: %2</source>
            <translation>Прибор на %1 мм: %2</translation>
        </message>
        <message>
            <source>Gauge at %1 mm: diameters from %2 (%3) to %4 µm (%5), at most %6 µm from the middle of the field</source>
            <translation>Прибор на %1 мм: диаметры от %2 (%3) до %4 мкм (%5), не дальше %6 мкм от середины поля</translation>
        </message>
        <message>
            <source>Place of the gauge from the headstock end of the ground length, mm</source>
            <translation>Место прибора от конца шлифуемой длины у передней бабки, мм</translation>
        </message>
    </context>
    <context>
        <name>HandoutView</name>
        <message>
            <source>Feeds around the step, with E1…E5</source>
            <translation>Подачи около разобранного шага с этапами Э1…Э5</translation>
        </message>
        <message>
            <source>Feeds over the whole cycle</source>
            <translation>Подачи за весь цикл</translation>
        </message>
        <message>
            <source>Zone profiles at the end</source>
            <translation>Профили зон в конце цикла</translation>
        </message>
        <message>
            <source>Actual feed under its limits</source>
            <translation>Фактическая подача и её пределы</translation>
        </message>
        <message>
            <source>Grid of dynamic programming</source>
            <translation>Сетка динамического программирования</translation>
        </message>
    </context>
    <context>
        <name>Help</name>
        <message>
            <source>Getting started</source>
            <translation>Начало работы</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Исходные данные</translation>
        </message>
        <message>
            <source>Views and results</source>
            <translation>Виды и результаты</translation>
        </message>
        <message>
            <source>The model</source>
            <translation>Модель</translation>
        </message>
        <message>
            <source>Working with the program</source>
            <translation>Работа с программой</translation>
        </message>
        <message>
            <source>Commands of the menus</source>
            <translation>Команды меню</translation>
        </message>
        <message>
            <source>Pages of the inputs</source>
            <translation>Страницы исходных данных</translation>
        </message>
        <message>
            <source>In a plot</source>
            <translation>На графике</translation>
        </message>
        <message>
            <source>Read with: %1</source>
            <translation>Используется при: %1</translation>
        </message>
        <message>
            <source>Choices: %1</source>
            <translation>Варианты: %1</translation>
        </message>
        <message>
            <source>Its inputs are those of %1.</source>
            <translation>Его исходные величины те же, что у %1.</translation>
        </message>
        <message>
            <source>In the project file: %1</source>
            <translation>В файле проекта: %1</translation>
        </message>
    </context>
    <context>
        <name>Hint</name>
        <message>
            <source>%1 Entered and shown on the diameter; the file and all results have it per side.</source>
            <translation>%1 Вводится и показывается на диаметр; в файле и во всех результатах — на сторону.</translation>
        </message>
        <message>
            <source>Allowed: %1</source>
            <translation>Допускается: %1</translation>
        </message>
        <message>
            <source>Usual: %1</source>
            <translation>Обычно: %1</translation>
        </message>
        <message>
            <source>Default: %1</source>
            <translation>По умолчанию: %1</translation>
        </message>
        <message>
            <source>Empty: %1</source>
            <translation>Пусто: %1</translation>
        </message>
        <message>
            <source>Source: %1</source>
            <translation>Источник: %1</translation>
        </message>
        <message>
            <source>allowed %1</source>
            <translation>допускается %1</translation>
        </message>
        <message>
            <source>usual %1</source>
            <translation>обычно %1</translation>
        </message>
        <message>
            <source>default %1</source>
            <translation>по умолчанию %1</translation>
        </message>
    </context>
    <context>
        <name>Input</name>
        <message>
            <source>Numbers of stages</source>
            <translation>Числа ступеней</translation>
        </message>
        <message>
            <source>Numbers of stages the search tries.</source>
            <translation>Числа ступеней, которые перебирает поиск.</translation>
        </message>
        <message>
            <source>Stock step per side</source>
            <translation>Шаг припуска на сторону</translation>
        </message>
        <message>
            <source>Stage stocks are multiples of it.</source>
            <translation>Припуски ступеней кратны этому шагу.</translation>
        </message>
        <message>
            <source>Feeds never rise</source>
            <translation>Подачи не возрастают</translation>
        </message>
        <message>
            <source>Neither feed rises from stage to stage.</source>
            <translation>Ни одна из подач не растёт от ступени к ступени.</translation>
        </message>
        <message>
            <source>Must be fit for</source>
            <translation>Годен для</translation>
        </message>
        <message>
            <source>The parts for which the cycle must meet the drawing.</source>
            <translation>Для каких деталей цикл должен обеспечить чертёж.</translation>
        </message>
        <message>
            <source>Levels of the radial feed</source>
            <translation>Уровни радиальной подачи</translation>
        </message>
        <message>
            <source>not searched</source>
            <translation>не перебирается</translation>
        </message>
        <message>
            <source>Per double stroke: a list, or from, to and step.</source>
            <translation>На двойной ход: список либо «от», «до» и шаг.</translation>
        </message>
        <message>
            <source>Levels of the axial feed</source>
            <translation>Уровни продольной подачи</translation>
        </message>
        <message>
            <source>A list, or from, to and step.</source>
            <translation>Список либо «от», «до» и шаг.</translation>
        </message>
        <message>
            <source>Levels of the continuous infeed</source>
            <translation>Уровни непрерывной подачи</translation>
        </message>
        <message>
            <source>cycles without one are searched</source>
            <translation>ищутся циклы без неё</translation>
        </message>
        <message>
            <source>A stage then has either one of these and no radial feed at the reversals, or one of the radial feeds: a list, or from, to and step.</source>
            <translation>Ступень имеет тогда одну из них и не имеет радиальной подачи на реверсах либо имеет одну из радиальных подач: список или от, до и шаг.</translation>
        </message>
        <message>
            <source>Continuous infeed by stage</source>
            <translation>Непрерывная подача по ступеням</translation>
        </message>
        <message>
            <source>Minimum and maximum for each stage in order, where it is fed continuously; equal values fix it.</source>
            <translation>Наименьшее и наибольшее значения для первой ступени, для второй и так далее, где подача непрерывная; два одинаковых числа закрепляют значение.</translation>
        </message>
        <message>
            <source>Levels of the plunge feed</source>
            <translation>Уровни врезной подачи</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Название</translation>
        </message>
        <message>
            <source>Name of the run.</source>
            <translation>Как назван расчёт.</translation>
        </message>
        <message>
            <source>When</source>
            <translation>Когда</translation>
        </message>
        <message>
            <source>Date and time in UTC, ISO 8601.</source>
            <translation>Дата и время по UTC, ISO 8601.</translation>
        </message>
        <message>
            <source>Engine version</source>
            <translation>Версия расчётного ядра</translation>
        </message>
        <message>
            <source>Version of the program that ran it.</source>
            <translation>Версия программы, которой выполнен расчёт.</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Исходные данные</translation>
        </message>
        <message>
            <source>The project as it was run.</source>
            <translation>Проект в том виде, в каком он рассчитан.</translation>
        </message>
        <message>
            <source>Summary</source>
            <translation>Итоги</translation>
        </message>
        <message>
            <source>Counts, final radii and deviations.</source>
            <translation>Числа ходов, конечные радиусы и отклонения.</translation>
        </message>
        <message>
            <source>Title</source>
            <translation>Название</translation>
        </message>
        <message>
            <source>Title of the project.</source>
            <translation>Название проекта.</translation>
        </message>
        <message>
            <source>Author</source>
            <translation>Автор</translation>
        </message>
        <message>
            <source>Who designed the cycle.</source>
            <translation>Кто спроектировал цикл.</translation>
        </message>
        <message>
            <source>Notes</source>
            <translation>Примечания</translation>
        </message>
        <message>
            <source>Anything worth knowing about the project.</source>
            <translation>Всё, что важно знать о проекте.</translation>
        </message>
        <message>
            <source>Operation</source>
            <translation>Операция</translation>
        </message>
        <message>
            <source>Traverse: the table strokes along the part. Plunge: the wheel covers the ground length and is fed radially.</source>
            <translation>С продольной подачей: стол ходит вдоль детали. Врезное: круг перекрывает длину шлифования и подаётся радиально.</translation>
        </message>
        <message>
            <source>Part</source>
            <translation>Деталь</translation>
        </message>
        <message>
            <source>Material</source>
            <translation>Материал</translation>
        </message>
        <message>
            <source>Wheel</source>
            <translation>Круг</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Станок</translation>
        </message>
        <message>
            <source>Gauge</source>
            <translation>ПАК</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Цикл</translation>
        </message>
        <message>
            <source>Sections along the length</source>
            <translation>Число сечений по длине</translation>
        </message>
        <message>
            <source>Sections at the middles of equal slices of the ground length, counted from the headstock.</source>
            <translation>Сечения посередине равных участков длины шлифования, счёт от передней бабки.</translation>
        </message>
        <message>
            <source>Sections coupled</source>
            <translation>Сечения связаны</translation>
        </message>
        <message>
            <source>Batch</source>
            <translation>Партия</translation>
        </message>
        <message>
            <source>no batch described</source>
            <translation>партия не описана</translation>
        </message>
        <message>
            <source>Optimisation</source>
            <translation>Оптимизация</translation>
        </message>
        <message>
            <source>no grid described</source>
            <translation>сетка не описана</translation>
        </message>
        <message>
            <source>Kept runs</source>
            <translation>Запомненные расчёты</translation>
        </message>
        <message>
            <source>Runs kept for comparison.</source>
            <translation>Расчёты, запомненные для сравнения.</translation>
        </message>
        <message>
            <source>Headstock stiffness</source>
            <translation>Жёсткость передней бабки</translation>
        </message>
        <message>
            <source>Force for one micrometre of deflection at the headstock.</source>
            <translation>Сила на один микрометр отжатия у передней бабки.</translation>
        </message>
        <message>
            <source>Tailstock stiffness</source>
            <translation>Жёсткость задней бабки</translation>
        </message>
        <message>
            <source>Force for one micrometre of deflection at the tailstock.</source>
            <translation>Сила на один микрометр отжатия у задней бабки.</translation>
        </message>
        <message>
            <source>Wheel head stiffness</source>
            <translation>Жёсткость шлифовальной бабки</translation>
        </message>
        <message>
            <source>Force for one micrometre of deflection at the wheel.</source>
            <translation>Сила на один микрометр отжатия у круга.</translation>
        </message>
        <message>
            <source>Contact stiffness at force</source>
            <translation>Контактная жёсткость при силе</translation>
        </message>
        <message>
            <source>rigid contact</source>
            <translation>жёсткий контакт</translation>
        </message>
        <message>
            <source>Range of the radial feed</source>
            <translation>Диапазон радиальной подачи</translation>
        </message>
        <message>
            <source>not limited</source>
            <translation>не ограничено</translation>
        </message>
        <message>
            <source>Minimum, maximum and step, per double stroke.</source>
            <translation>Наименьшая, наибольшая и шаг, на двойной ход.</translation>
        </message>
        <message>
            <source>Range of the axial feed</source>
            <translation>Диапазон продольной подачи</translation>
        </message>
        <message>
            <source>Minimum, maximum and step.</source>
            <translation>Наименьшее, наибольшее и шаг.</translation>
        </message>
        <message>
            <source>Range of the plunge feed</source>
            <translation>Диапазон врезной подачи</translation>
        </message>
        <message>
            <source>Range of the continuous infeed</source>
            <translation>Диапазон непрерывной подачи</translation>
        </message>
        <message>
            <source>Minimum, maximum and step of the radial infeed while the table travels; [0, 0, 0] for a machine without it.</source>
            <translation>Наименьшее, наибольшее и шаг радиальной подачи во время хода стола; [0, 0, 0] — у станка её нет.</translation>
        </message>
        <message>
            <source>Range of the work speed</source>
            <translation>Диапазон частоты вращения заготовки</translation>
        </message>
        <message>
            <source>Model of the grinder.</source>
            <translation>Модель шлифовального станка.</translation>
        </message>
        <message>
            <source>Wheel speed</source>
            <translation>Скорость круга</translation>
        </message>
        <message>
            <source>Worn wheel runs at</source>
            <translation>У изношенного круга</translation>
        </message>
        <message>
            <source>The quantity that the drive keeps when the wheel gets smaller, in a batch, a sweep, a set-up and from dressing to dressing: the peripheral speed, or the revolutions, so that the speed falls with the diameter. The wheel speed is that of the wheel diameter as it is given.</source>
            <translation>Что сохраняет привод, когда круг становится меньше — в партии, при варьировании, в установе и от правки до правки: окружную скорость или частоту вращения, так что скорость падает вместе с диаметром. Скорость круга относится к заданному диаметру круга.</translation>
        </message>
        <message>
            <source>Wear since the last compensation</source>
            <translation>Износ после последней компенсации</translation>
        </message>
        <message>
            <source>Wheel radius assumed by the position control minus the actual wheel radius. Each dressing compensates it: the control is set to the new radius. In a set-up the wear of the wheel adds to it.</source>
            <translation>Насколько радиус круга меньше того, который учитывает управление по положению. Каждая правка компенсирует износ: системе управления задаётся новый радиус. В установе к нему прибавляется износ круга.</translation>
        </message>
        <message>
            <source>Peripheral speed of the wheel.</source>
            <translation>Окружная скорость круга.</translation>
        </message>
        <message>
            <source>Work speed</source>
            <translation>Частота вращения заготовки</translation>
        </message>
        <message>
            <source>Revolutions of the part; V_d = π·d·n.</source>
            <translation>Частота вращения заготовки; V_d = π·d·n.</translation>
        </message>
        <message>
            <source>Plunge-in feed at reversal</source>
            <translation>Подача врезания на реверсе</translation>
        </message>
        <message>
            <source>Speed of the infeed at a reversal: an infeed S takes ⌈n·S/S_rad⌉ revolutions.</source>
            <translation>Скорость врезания на реверсе: подача S занимает ⌈n·S/S_rad⌉ оборотов.</translation>
        </message>
        <message>
            <source>Overrun at the entry</source>
            <translation>Перебег на входе</translation>
        </message>
        <message>
            <source>Distance that the wheel runs past the entry end; the entry reversal zone is B − o1 long.</source>
            <translation>На сколько круг выходит за торец входа; длина реверсной зоны РЗ1 равна B − o1.</translation>
        </message>
        <message>
            <source>Overrun at the exit</source>
            <translation>Перебег на выходе</translation>
        </message>
        <message>
            <source>Distance that the wheel runs past the exit end; the exit reversal zone is B − o2 long.</source>
            <translation>На сколько круг выходит за торец выхода; длина реверсной зоны РЗ2 равна B − o2.</translation>
        </message>
        <message>
            <source>Dwell at the entry</source>
            <translation>Выстой на входе</translation>
        </message>
        <message>
            <source>Spark-out at the entry reversal, twice a double stroke, in whole revolutions of the part.</source>
            <translation>Выхаживание на реверсе у входа, дважды за двойной ход, целыми оборотами детали.</translation>
        </message>
        <message>
            <source>Dwell at the exit</source>
            <translation>Выстой на выходе</translation>
        </message>
        <message>
            <source>Spark-out at the exit reversal, once a double stroke, in whole revolutions of the part.</source>
            <translation>Выхаживание на реверсе у выхода, один раз за двойной ход, целыми оборотами детали.</translation>
        </message>
        <message>
            <source>Compliance</source>
            <translation>Податливость</translation>
        </message>
        <message>
            <source>from stiffness and shaft</source>
            <translation>по жёсткости узлов и валу</translation>
        </message>
        <message>
            <source>Deflection of the technological system for one newton at the wheel: one value a zone (traverse) or a section (plunge).</source>
            <translation>Отжатие технологической системы на один ньютон у круга: по значению на зону (с продольной подачей) или на сечение (врезное).</translation>
        </message>
        <message>
            <source>Stiffness of the units</source>
            <translation>Жёсткость узлов</translation>
        </message>
        <message>
            <source>not stated</source>
            <translation>не указано</translation>
        </message>
        <message>
            <source>Headstock, tailstock and wheel head, for a compliance that is computed.</source>
            <translation>Передняя, задняя и шлифовальная бабки; нужна, когда податливость вычисляется.</translation>
        </message>
        <message>
            <source>Geometric runout</source>
            <translation>Геометрическое биение</translation>
        </message>
        <message>
            <source>Runout of centres and spindle; it adds to every runout. At 0 it is not known.</source>
            <translation>Биение центров и шпинделя; прибавляется к каждому биению. 0 — неизвестно.</translation>
        </message>
        <message>
            <source>Wheel drive power</source>
            <translation>Мощность привода круга</translation>
        </message>
        <message>
            <source>Power of the wheel drive.</source>
            <translation>Мощность привода круга.</translation>
        </message>
        <message>
            <source>Work drive power</source>
            <translation>Мощность привода изделия</translation>
        </message>
        <message>
            <source>Power of the work drive.</source>
            <translation>Мощность привода вращения изделия.</translation>
        </message>
        <message>
            <source>Feed change delay</source>
            <translation>Запаздывание смены подачи</translation>
        </message>
        <message>
            <source>Time from the gauge&apos;s command to the feed of the next stage: a stage that the gauge ends continues for this time in whole steps. The last command only draws the wheel back, without delay.</source>
            <translation>Время от команды прибора до подачи следующей ступени: ступень, которую заканчивает прибор, продолжается на столько целых двойных ходов или оборотов, сколько оно длится. Последняя команда только отводит круг и не запаздывает.</translation>
        </message>
        <message>
            <source>Entry zone is at the</source>
            <translation>Зона входа РЗ1</translation>
        </message>
        <message>
            <source>Which end of the part the wheel enters at.</source>
            <translation>С какого конца детали круг входит в работу.</translation>
        </message>
        <message>
            <source>Infeed at the reversals</source>
            <translation>Подача на реверсах</translation>
        </message>
        <message>
            <source>Reversal at which the infeed of a double stroke takes place: at the entry, at the exit, or half of it at each.</source>
            <translation>Где подаётся радиальная подача двойного хода: у входа, у выхода или пополам.</translation>
        </message>
        <message>
            <source>Wheel contact</source>
            <translation>Контакт круга</translation>
        </message>
        <message>
            <source>Contact compliance of the wheel in series, beyond the sources.</source>
            <translation>Контактная податливость круга, включённая последовательно; дополнение к источникам.</translation>
        </message>
        <message>
            <source>Machine ranges</source>
            <translation>Диапазоны станка</translation>
        </message>
        <message>
            <source>Radial feed per double stroke</source>
            <translation>Радиальная подача на двойной ход</translation>
        </message>
        <message>
            <source>not used</source>
            <translation>не используется</translation>
        </message>
        <message>
            <source>Programmed infeed at the reversals of each double stroke.</source>
            <translation>Программная врезная подача на реверсах каждого двойного хода.</translation>
        </message>
        <message>
            <source>Continuous radial infeed</source>
            <translation>Непрерывная радиальная подача</translation>
        </message>
        <message>
            <source>Radial infeed that continues while the table travels and dwells, in addition to the radial feed at the reversals, which may then be 0.</source>
            <translation>Радиальная подача, которая идёт всё время, при ходах стола и на выстоях, дополнительно к подаче на реверсах, которая тогда может быть равна 0.</translation>
        </message>
        <message>
            <source>Axial feed</source>
            <translation>Продольная подача</translation>
        </message>
        <message>
            <source>Table speed; S_ax/n per revolution is the effective width of cut, at most the wheel width.</source>
            <translation>Скорость стола; S_ax/n на оборот — эффективная ширина резания, не больше высоты круга.</translation>
        </message>
        <message>
            <source>Radial feed</source>
            <translation>Радиальная подача</translation>
        </message>
        <message>
            <source>Radial stock of the stage. The stage ends when only the stock of the later stages remains.</source>
            <translation>Припуск ступени на сторону. Ступень кончается, когда до размера остаётся припуск следующих ступеней.</translation>
        </message>
        <message>
            <source>Spark-out</source>
            <translation>Выхаживание</translation>
        </message>
        <message>
            <source>an ordinary stage</source>
            <translation>обычная ступень</translation>
        </message>
        <message>
            <source>The last stage may have no feed: a number of double strokes or revolutions, or until size.</source>
            <translation>Последняя ступень может быть без подачи: заданное число двойных ходов или оборотов либо до размера.</translation>
        </message>
        <message>
            <source>Stages</source>
            <translation>Ступени</translation>
        </message>
        <message>
            <source>Stages of the cycle in the order they run.</source>
            <translation>Ступени цикла в порядке выполнения.</translation>
        </message>
        <message>
            <source>Stages switch</source>
            <translation>Ступени переключаются</translation>
        </message>
        <message>
            <source>Stages switch by the in-process gauge&apos;s reading, or by the position the wheel head has been fed to.</source>
            <translation>Ступени переключаются по показанию прибора активного контроля или по положению, до которого подана шлифовальная бабка.</translation>
        </message>
        <message>
            <source>The gauge reads the</source>
            <translation>Прибор показывает</translation>
        </message>
        <message>
            <source>Which of the diameters of a revolution the gauge reports. In a bore minimum and maximum change places.</source>
            <translation>Какой из диаметров за оборот выдаёт прибор. В отверстии наименьший и наибольший меняются местами.</translation>
        </message>
        <message>
            <source>Gauge at section</source>
            <translation>Прибор в сечении</translation>
        </message>
        <message>
            <source>the middle one</source>
            <translation>среднее</translation>
        </message>
        <message>
            <source>Section the gauge watches, counted from the headstock: from 1 in the window and in reports, from 0 in files and on the command line. In traverse grinding the gauge is in the middle of the zone between the reversals.</source>
            <translation>Номер сечения, за которым следит прибор, считая от передней бабки: в окне и отчётах с 1, в файлах и командной строке с 0. При шлифовании с продольной подачей прибор стоит посередине нереверсной зоны.</translation>
        </message>
        <message>
            <source>Gauge at a free position</source>
            <translation>Прибор в произвольном месте</translation>
        </message>
        <message>
            <source>at a section</source>
            <translation>в сечении</translation>
        </message>
        <message>
            <source>Position along the ground length from its headstock end.</source>
            <translation>Положение по длине шлифования от её конца у передней бабки.</translation>
        </message>
        <message>
            <source>Compliance at the gauge</source>
            <translation>Податливость у прибора</translation>
        </message>
        <message>
            <source>from the shaft, or between the sections</source>
            <translation>по валу или между сечениями</translation>
        </message>
        <message>
            <source>Compliance at the gauge&apos;s free position.</source>
            <translation>Податливость в том месте, где стоит прибор.</translation>
        </message>
        <message>
            <source>Gauge commands</source>
            <translation>Число команд прибора</translation>
        </message>
        <message>
            <source>Number of stages that the gauge can switch.</source>
            <translation>Сколько ступеней может переключить прибор.</translation>
        </message>
        <message>
            <source>Gauge delay</source>
            <translation>Запаздывание прибора</translation>
        </message>
        <message>
            <source>Time from the gauge&apos;s reading to its command. Every stage that the gauge ends, also the last one, continues for this time in whole double strokes or revolutions.</source>
            <translation>Время от показания прибора до его команды. Каждая ступень, которую заканчивает прибор, продолжается на столько целых двойных ходов или оборотов, сколько оно длится, и последняя тоже.</translation>
        </message>
        <message>
            <source>Marking</source>
            <translation>Маркировка</translation>
        </message>
        <message>
            <source>Marking of the wheel, for example 25А F60 L 6 V.</source>
            <translation>Маркировка круга, например 25А F60 L 6 V.</translation>
        </message>
        <message>
            <source>Wheel diameter</source>
            <translation>Диаметр круга</translation>
        </message>
        <message>
            <source>Diameter of the wheel; D_e = d·D/(D ± d) sets the contact length √(a·D_e).</source>
            <translation>Диаметр круга; D_e = d·D/(D ± d) определяет длину контакта √(a·D_e).</translation>
        </message>
        <message>
            <source>Wheel width</source>
            <translation>Высота круга</translation>
        </message>
        <message>
            <source>Width of the wheel. A plunge wheel covers the ground length.</source>
            <translation>Высота (ширина) круга. При врезном шлифовании круг перекрывает длину шлифования.</translation>
        </message>
        <message>
            <source>Dullness</source>
            <translation>Степень затупления</translation>
        </message>
        <message>
            <source>Share of the working surface that is wear flats: 0 is ideally sharp. It drives the friction term k_r = η·σ_i·√D_e/3.</source>
            <translation>Доля площадок износа в рабочей поверхности: 0 — идеально острый круг. Определяет составляющую трения k_r = η·σ_i·√D_e/3.</translation>
        </message>
        <message>
            <source>Grain size</source>
            <translation>Размер зерна</translation>
        </message>
        <message>
            <source>Mean grain size.</source>
            <translation>Средний размер зерна.</translation>
        </message>
        <message>
            <source>Grain share</source>
            <translation>Доля зерна</translation>
        </message>
        <message>
            <source>Share of grain in the wheel&apos;s volume.</source>
            <translation>Доля зерна в объёме круга.</translation>
        </message>
        <message>
            <source>Bond share</source>
            <translation>Доля связки</translation>
        </message>
        <message>
            <source>Share of bond in the wheel&apos;s volume.</source>
            <translation>Доля связки в объёме круга.</translation>
        </message>
        <message>
            <source>Grain tip angle</source>
            <translation>Угол вершины зерна</translation>
        </message>
        <message>
            <source>Angle of the grain tips.</source>
            <translation>Угол при вершине зёрен.</translation>
        </message>
        <message>
            <source>Dressing chipping level</source>
            <translation>Уровень сколов при правке</translation>
        </message>
        <message>
            <source>Depth over which dressing chips the grains.</source>
            <translation>Глубина, на которой правка скалывает зёрна.</translation>
        </message>
        <message>
            <source>Roughness calibration</source>
            <translation>Поправка шероховатости</translation>
        </message>
        <message>
            <source>Measured Ra divided by computed Ra. At 1 it is not known, and Ra is given as a range. A measured Ra sets it.</source>
            <translation>Отношение измеренной Ra к расчётной; при 1 оно неизвестно, и Ra — диапазон. Задаётся измеренной Ra.</translation>
        </message>
        <message>
            <source>Measured Ra</source>
            <translation>Измеренная Ra</translation>
        </message>
        <message>
            <source>Ra of a part ground with this wheel, dressed as it is. It sets the roughness calibration.</source>
            <translation>Ra детали, прошлифованной этим кругом при той же правке. Задаёт поправку шероховатости.</translation>
        </message>
        <message>
            <source>Infeed it was measured at</source>
            <translation>Подача, при которой измерена</translation>
        </message>
        <message>
            <source>of the cycle's last feed</source>
            <translation>последняя подача цикла</translation>
        </message>
        <message>
            <source>Per revolution of the part in a plunge, otherwise per double stroke, at the speeds and diameters stated.</source>
            <translation>На оборот детали при врезном шлифовании, иначе на двойной ход, при заданных скоростях и диаметрах.</translation>
        </message>
        <message>
            <source>Spark-out it was measured at</source>
            <translation>Выхаживание, после которого измерена</translation>
        </message>
        <message>
            <source>as many as in the cycle</source>
            <translation>сколько в цикле</translation>
        </message>
        <message>
            <source>Revolutions in a plunge, otherwise double strokes, after that infeed.</source>
            <translation>Обороты при врезном шлифовании, иначе двойные ходы после этой подачи.</translation>
        </message>
        <message>
            <source>Ra is an estimate</source>
            <translation>Ra — оценка</translation>
        </message>
        <message>
            <source>Ra of a ground part, with the infeed and spark-out that it was measured at.</source>
            <translation>Ra прошлифованной детали с подачей и выхаживанием, при которых она измерена.</translation>
        </message>
        <message>
            <source>Grain surface energy</source>
            <translation>Поверхностная энергия зерна</translation>
        </message>
        <message>
            <source>self-sharpening not checked</source>
            <translation>самозатачивание не проверяется</translation>
        </message>
        <message>
            <source>Fracture surface energy of the grain.</source>
            <translation>Поверхностная энергия разрушения зерна.</translation>
        </message>
        <message>
            <source>Grain modulus</source>
            <translation>Модуль упругости зерна</translation>
        </message>
        <message>
            <source>Young&apos;s modulus of the grain.</source>
            <translation>Модуль Юнга зерна.</translation>
        </message>
        <message>
            <source>Bond surface energy</source>
            <translation>Поверхностная энергия связки</translation>
        </message>
        <message>
            <source>Fracture surface energy of the bond.</source>
            <translation>Поверхностная энергия разрушения связки.</translation>
        </message>
        <message>
            <source>Bond modulus</source>
            <translation>Модуль упругости связки</translation>
        </message>
        <message>
            <source>Young&apos;s modulus of the bond.</source>
            <translation>Модуль Юнга связки.</translation>
        </message>
        <message>
            <source>Bond bridge</source>
            <translation>Мостик связки</translation>
        </message>
        <message>
            <source>from the grain lattice</source>
            <translation>по решётке зёрен</translation>
        </message>
        <message>
            <source>Diameter of a bond bridge.</source>
            <translation>Диаметр мостика связки.</translation>
        </message>
        <message>
            <source>Grains per area</source>
            <translation>Зёрен на единице площади</translation>
        </message>
        <message>
            <source>Grains on a square millimetre of the wheel.</source>
            <translation>Число зёрен на квадратном миллиметре круга.</translation>
        </message>
        <message>
            <source>Roundness</source>
            <translation>Допуск круглости</translation>
        </message>
        <message>
            <source>not required</source>
            <translation>не требуется</translation>
        </message>
        <message>
            <source>Maximum roundness deviation the drawing allows.</source>
            <translation>Наибольшее отклонение от круглости по чертежу.</translation>
        </message>
        <message>
            <source>Radial runout</source>
            <translation>Радиальное биение</translation>
        </message>
        <message>
            <source>Maximum R_max − R_min of a section about the centre axis the drawing allows.</source>
            <translation>Наибольшая по чертежу разность R_max − R_min сечения относительно оси центров.</translation>
        </message>
        <message>
            <source>Cylindricity</source>
            <translation>Допуск цилиндричности</translation>
        </message>
        <message>
            <source>Maximum cylindricity deviation the drawing allows.</source>
            <translation>Наибольшее отклонение от цилиндричности по чертежу.</translation>
        </message>
        <message>
            <source>Total radial runout</source>
            <translation>Полное радиальное биение</translation>
        </message>
        <message>
            <source>Maximum radial runout over the whole ground length.</source>
            <translation>Наибольшее радиальное биение на всей длине шлифования.</translation>
        </message>
        <message>
            <source>Maximum arithmetic mean roughness the drawing allows.</source>
            <translation>Наибольшее среднее арифметическое отклонение профиля по чертежу.</translation>
        </message>
        <message>
            <source>Segment length</source>
            <translation>Длина ступени вала</translation>
        </message>
        <message>
            <source>Length of one step of the shaft, from the headstock on.</source>
            <translation>Длина одной ступени вала, счёт от передней бабки.</translation>
        </message>
        <message>
            <source>Segment diameter</source>
            <translation>Диаметр ступени вала</translation>
        </message>
        <message>
            <source>Diameter of one step of the shaft.</source>
            <translation>Диаметр одной ступени вала.</translation>
        </message>
        <message>
            <source>Position of the steady rest</source>
            <translation>Положение люнета</translation>
        </message>
        <message>
            <source>Distance from the headstock end of the shaft.</source>
            <translation>Расстояние от конца вала у передней бабки.</translation>
        </message>
        <message>
            <source>Stiffness of the steady rest</source>
            <translation>Жёсткость люнета</translation>
        </message>
        <message>
            <source>Force at the rest for one micrometre of deflection there.</source>
            <translation>Сила на люнете на один микрометр отжатия в этом месте.</translation>
        </message>
        <message>
            <source>Quill length</source>
            <translation>Вылет оправки</translation>
        </message>
        <message>
            <source>Overhang of the wheel&apos;s spindle in internal grinding.</source>
            <translation>Вылет оправки круга при внутреннем шлифовании.</translation>
        </message>
        <message>
            <source>Quill diameter</source>
            <translation>Диаметр оправки</translation>
        </message>
        <message>
            <source>Diameter of the wheel&apos;s spindle in internal grinding.</source>
            <translation>Диаметр оправки круга при внутреннем шлифовании.</translation>
        </message>
        <message>
            <source>Segments of the shaft</source>
            <translation>Ступени вала</translation>
        </message>
        <message>
            <source>Steps of the shaft from the headstock on; needed when the compliance is computed from the stiffness.</source>
            <translation>Ступени вала от передней бабки; нужны, когда податливость вычисляется по жёсткости.</translation>
        </message>
        <message>
            <source>Ground length begins at</source>
            <translation>Начало длины шлифования</translation>
        </message>
        <message>
            <source>Distance from the headstock end of the shaft to the ground length.</source>
            <translation>Расстояние от конца вала у передней бабки до длины шлифования.</translation>
        </message>
        <message>
            <source>Modulus of elasticity</source>
            <translation>Модуль упругости</translation>
        </message>
        <message>
            <source>Young&apos;s modulus of the shaft: steel about 210.</source>
            <translation>Модуль Юнга вала: у стали около 210.</translation>
        </message>
        <message>
            <source>Mounting</source>
            <translation>Установка</translation>
        </message>
        <message>
            <source>Between centres, or overhanging from a chuck.</source>
            <translation>В центрах или консольно в патроне.</translation>
        </message>
        <message>
            <source>Steady rests</source>
            <translation>Люнеты</translation>
        </message>
        <message>
            <source>Springs that support the shaft along its length.</source>
            <translation>Пружины, поддерживающие вал по длине.</translation>
        </message>
        <message>
            <source>Quill</source>
            <translation>Оправка круга</translation>
        </message>
        <message>
            <source>none</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>The wheel&apos;s spindle in internal grinding, a cantilever.</source>
            <translation>Оправка круга при внутреннем шлифовании, консоль.</translation>
        </message>
        <message>
            <source>Name of the part, as it stands in the drawing.</source>
            <translation>Наименование детали по чертежу.</translation>
        </message>
        <message>
            <source>Surface</source>
            <translation>Поверхность</translation>
        </message>
        <message>
            <source>External: a shaft. Internal: a bore, ground by a wheel on a quill.</source>
            <translation>Наружная — вал; внутренняя — отверстие, его шлифуют кругом на оправке.</translation>
        </message>
        <message>
            <source>Blind bore</source>
            <translation>Глухое отверстие</translation>
        </message>
        <message>
            <source>A bore with a wall at its headstock end, where the wheel cannot leave it: the overrun there is 0, or negative where the wheel turns before the wall.</source>
            <translation>У торца со стороны передней бабки отверстие закрыто стенкой, круг там не выходит: перебег равен 0 или отрицателен, если круг разворачивается не доходя до стенки.</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Диаметр</translation>
        </message>
        <message>
            <source>Nominal diameter of the drawing.</source>
            <translation>Номинальный диаметр по чертежу.</translation>
        </message>
        <message>
            <source>Upper deviation</source>
            <translation>Верхнее отклонение</translation>
        </message>
        <message>
            <source>Upper limit of the diameter minus the nominal diameter.</source>
            <translation>Наибольший предельный диаметр минус номинальный.</translation>
        </message>
        <message>
            <source>Lower deviation</source>
            <translation>Нижнее отклонение</translation>
        </message>
        <message>
            <source>Lower limit of the diameter minus the nominal diameter.</source>
            <translation>Наименьший предельный диаметр минус номинальный.</translation>
        </message>
        <message>
            <source>Ground length</source>
            <translation>Длина шлифования</translation>
        </message>
        <message>
            <source>Length of the ground surface.</source>
            <translation>Длина шлифуемой поверхности.</translation>
        </message>
        <message>
            <source>Stock per side</source>
            <translation>Припуск на сторону</translation>
        </message>
        <message>
            <source>Minimum radial stock: minimum radius of the blank minus the target radius.</source>
            <translation>Наименьший припуск на сторону: на сколько наименьший радиус заготовки больше целевого.</translation>
        </message>
        <message>
            <source>Initial runout</source>
            <translation>Исходное биение</translation>
        </message>
        <message>
            <source>R_max − R_min of the blank. R_max = R_t + Π + ΔR is where the wheel touches first.</source>
            <translation>R_max − R_min заготовки. На R_max = R_t + Π + ΔR круг касается впервые.</translation>
        </message>
        <message>
            <source>Radii per section</source>
            <translation>Число радиусов в сечении</translation>
        </message>
        <message>
            <source>Radii followed in each cross-section at equal angles, an even number.</source>
            <translation>Сколько радиусов отслеживается в каждом поперечном сечении через равные углы, чётное число.</translation>
        </message>
        <message>
            <source>Form of the blank</source>
            <translation>Форма заготовки</translation>
        </message>
        <message>
            <source>Lobes</source>
            <translation>Число граней</translation>
        </message>
        <message>
            <source>Number of lobes: R = R_max − ΔR/2·(1 − cos nφ).</source>
            <translation>Число граней огранки: R = R_max − ΔR/2·(1 − cos nφ).</translation>
        </message>
        <message>
            <source>Measured profile</source>
            <translation>Измеренный профиль</translation>
        </message>
        <message>
            <source>not measured</source>
            <translation>не измерено</translation>
        </message>
        <message>
            <source>Deviations from the maximum radius at equal angles, one a radius; only their differences matter.</source>
            <translation>Отклонения от наибольшего радиуса через равные углы, по одному на радиус; важны только их разности.</translation>
        </message>
        <message>
            <source>Target diameter</source>
            <translation>Целевой диаметр</translation>
        </message>
        <message>
            <source>middle of the tolerance band</source>
            <translation>середина поля допуска</translation>
        </message>
        <message>
            <source>The diameter the gauge is set to.</source>
            <translation>Диаметр, на который настроен прибор.</translation>
        </message>
        <message>
            <source>Tolerances</source>
            <translation>Допуски</translation>
        </message>
        <message>
            <source>Shaft</source>
            <translation>Вал</translation>
        </message>
        <message>
            <source>Uniform</source>
            <translation>Равномерное</translation>
        </message>
        <message>
            <source>not this form</source>
            <translation>не так</translation>
        </message>
        <message>
            <source>Normal</source>
            <translation>Нормальное</translation>
        </message>
        <message>
            <source>Mean and standard deviation.</source>
            <translation>Среднее и среднее квадратическое отклонение.</translation>
        </message>
        <message>
            <source>Within</source>
            <translation>Границы усечения</translation>
        </message>
        <message>
            <source>not truncated</source>
            <translation>не усечено</translation>
        </message>
        <message>
            <source>Bounds that truncate the normal distribution.</source>
            <translation>Границы усечения нормального распределения.</translation>
        </message>
        <message>
            <source>Grows</source>
            <translation>Рост</translation>
        </message>
        <message>
            <source>Values of the first and of the last part between two dressings.</source>
            <translation>От первой до последней детали между двумя правками.</translation>
        </message>
        <message>
            <source>Parts between dressings</source>
            <translation>Деталей между правками</translation>
        </message>
        <message>
            <source>Thermal expansion</source>
            <translation>Тепловое расширение</translation>
        </message>
        <message>
            <source>Growth of one metre of the part per kelvin; the gauge reads a warm part too large by it.</source>
            <translation>На сколько метр детали удлиняется с каждым кельвином: на столько больше показывает прибор по тёплой детали.</translation>
        </message>
        <message>
            <source>Gauge error</source>
            <translation>Погрешность прибора</translation>
        </message>
        <message>
            <source>Amount by which the gauge reads the diameter too large. Under gauge control the part, also a bore, ends smaller by this amount. In a batch its random part and its drift are factors.</source>
            <translation>На сколько прибор показывает диаметр больше. При управлении от прибора деталь, и отверстие тоже, выходит меньше на столько же. В партии её случайная часть и дрейф — факторы.</translation>
        </message>
        <message>
            <source>Part warmer at the gauge</source>
            <translation>Деталь теплее у прибора</translation>
        </message>
        <message>
            <source>Temperature of the part at the gauge above the temperature that the gauge is set for. As the part cools, it shrinks by α·d·ΔT. The heating by grinding is not computed.</source>
            <translation>На сколько деталь у прибора теплее, чем при его настройке. Остыв, она меньше на α·d·ΔT. Нагрев шлифованием не рассчитывается.</translation>
        </message>
        <message>
            <source>Highest wheel speed</source>
            <translation>Наибольшая скорость круга</translation>
        </message>
        <message>
            <source>Peripheral speed up to which the machine drives a wheel; a starting cycle uses it if the wheel allows it.</source>
            <translation>Окружная скорость, до которой станок вращает круг; исходный цикл берёт её, если круг её допускает.</translation>
        </message>
        <message>
            <source>Gauge repeatability</source>
            <translation>Повторяемость прибора</translation>
        </message>
        <message>
            <source>Standard deviation of the in-process gauge's reading of a diameter. A batch with the gauge's error as a factor scatters by it.</source>
            <translation>Среднее квадратическое отклонение отсчёта диаметра прибором активного контроля. По ней рассеивается партия с фактором погрешности прибора.</translation>
        </message>
        <message>
            <source>Gauge drift</source>
            <translation>Дрейф прибора</translation>
        </message>
        <message>
            <source>Increase of the reading of the in-process gauge per hour since it was set. A batch with that time as a factor drifts by it.</source>
            <translation>На сколько больше показывает прибор активного контроля с каждым часом после настройки. По нему смещается партия с фактором этого времени.</translation>
        </message>
        <message>
            <source>Delay of the machine's gauge</source>
            <translation>Запаздывание прибора станка</translation>
        </message>
        <message>
            <source>Time from the reading of the machine's gauge to its command, where the gauge delay itself is not given.</source>
            <translation>Время от показания прибора станка до его команды, если само запаздывание прибора не задано.</translation>
        </message>
        <message>
            <source>that of the machine's gauge, or none</source>
            <translation>как у прибора станка, иначе нет</translation>
        </message>
        <message>
            <source>Random error of the gauge</source>
            <translation>Случайная погрешность прибора</translation>
        </message>
        <message>
            <source>Number of standard deviations; it multiplies the machine&apos;s gauge repeatability. A normal law with mean 0 and deviation 1 is the gauge of the machine as given.</source>
            <translation>В средних квадратических отклонениях: умножает повторяемость прибора станка. Нормальный закон со средним 0 и отклонением 1 — прибор, каков он у станка.</translation>
        </message>
        <message>
            <source>Time since the gauge was set</source>
            <translation>Время с настройки прибора</translation>
        </message>
        <message>
            <source>it does not drift</source>
            <translation>дрейфа нет</translation>
        </message>
        <message>
            <source>It multiplies the machine&apos;s gauge drift. Growing from 0, it rises by the piece time from part to part; the parts between dressings are those from one setting of the gauge to the next.</source>
            <translation>Умножает дрейф прибора станка. Растёт от детали к детали с 0: каждая деталь шлифуется на штучное время позже предыдущей; деталей между правками — столько, сколько от настройки прибора до следующей.</translation>
        </message>
        <message>
            <source>Difference from the temperature that the gauge is set for: as the part cools, it shrinks by α·d·ΔT.</source>
            <translation>На сколько теплее, чем при настройке прибора: остыв, деталь меньше на α·d·ΔT.</translation>
        </message>
        <message>
            <source>the whole batch</source>
            <translation>вся партия</translation>
        </message>
        <message>
            <source>Number of parts ground between two dressings.</source>
            <translation>Сколько деталей шлифуют между двумя правками.</translation>
        </message>
        <message>
            <source>does not scatter</source>
            <translation>не рассеивается</translation>
        </message>
        <message>
            <source>Flow stress</source>
            <translation>Интенсивность напряжений</translation>
        </message>
        <message>
            <source>Factor on every compliance.</source>
            <translation>Множитель к каждой податливости.</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Число деталей</translation>
        </message>
        <message>
            <source>Number of parts simulated.</source>
            <translation>Число моделируемых деталей.</translation>
        </message>
        <message>
            <source>Seed</source>
            <translation>Номер выборки</translation>
        </message>
        <message>
            <source>The same seed gives the same batch.</source>
            <translation>Один и тот же номер выборки даёт одну и ту же партию.</translation>
        </message>
        <message>
            <source>Scenarios</source>
            <translation>Сценарии</translation>
        </message>
        <message>
            <source>Method of sampling the factors.</source>
            <translation>Как выбираются значения факторов.</translation>
        </message>
        <message>
            <source>Factors</source>
            <translation>Факторы</translation>
        </message>
        <message>
            <source>Correlation</source>
            <translation>Корреляция</translation>
        </message>
        <message>
            <source>independent</source>
            <translation>независимы</translation>
        </message>
        <message>
            <source>Correlation matrix of the factors given, in their order.</source>
            <translation>Матрица корреляций заданных факторов в их порядке.</translation>
        </message>
        <message>
            <source>Grade</source>
            <translation>Марка</translation>
        </message>
        <message>
            <source>Steel or iron grade, as it stands in the drawing.</source>
            <translation>Марка стали или чугуна по чертежу.</translation>
        </message>
        <message>
            <source>Hardness</source>
            <translation>Твёрдость</translation>
        </message>
        <message>
            <source>Hardness of the part; for the record, as the force law uses the flow stress.</source>
            <translation>Твёрдость детали; для сведения — в закон силы входит интенсивность напряжений.</translation>
        </message>
        <message>
            <source>Stress intensity of the metal in the cutting zone: k_s = ε_i·tg β·σ_i·V_d/V_k, k_r = η·σ_i·√D_e/3.</source>
            <translation>Интенсивность напряжений металла в зоне резания: k_s = ε_i·tg β·σ_i·V_d/V_k, k_r = η·σ_i·√D_e/3.</translation>
        </message>
        <message>
            <source>Shear factor</source>
            <translation>Множитель сдвига</translation>
        </message>
        <message>
            <source>Shear strain intensity times the tangent of the force angle, in the normal force.</source>
            <translation>Интенсивность деформаций сдвига на тангенс угла действия силы; входит в нормальную силу.</translation>
        </message>
        <message>
            <source>Shear strain</source>
            <translation>Деформация сдвига</translation>
        </message>
        <message>
            <source>Shear strain intensity, in the tangential force P_z = b·(ε_i·σ_i·V_d/V_k·a + μ·k_r·√a).</source>
            <translation>Интенсивность деформаций сдвига; входит в касательную силу P_z = b·(ε_i·σ_i·V_d/V_k·a + μ·k_r·√a).</translation>
        </message>
        <message>
            <source>Friction</source>
            <translation>Коэффициент трения</translation>
        </message>
        <message>
            <source>Coefficient of friction of wear flats on metal.</source>
            <translation>Коэффициент трения площадок износа о металл.</translation>
        </message>
        <message>
            <source>Thermal conductivity</source>
            <translation>Тепло­проводность</translation>
        </message>
        <message>
            <source>Value of the part near the surface.</source>
            <translation>Детали вблизи поверхности.</translation>
        </message>
        <message>
            <source>Thermal diffusivity</source>
            <translation>Температуро­проводность</translation>
        </message>
        <message>
            <source>Burn temperature rise</source>
            <translation>Нагрев до прижога</translation>
        </message>
        <message>
            <source>burn not checked</source>
            <translation>прижог не проверяется</translation>
        </message>
        <message>
            <source>Temperature rise above which the metal&apos;s structure changes.</source>
            <translation>Превышение температуры, при котором меняется структура металла.</translation>
        </message>
        <message>
            <source>Heat into the part</source>
            <translation>Доля тепла в деталь</translation>
        </message>
        <message>
            <source>Share of the grinding heat that enters the part.</source>
            <translation>Доля тепла шлифования, уходящая в деталь.</translation>
        </message>
        <message>
            <source>Stage stock per side</source>
            <translation>Припуск ступени на сторону</translation>
        </message>
        <message>
            <source>Position</source>
            <translation>Положение</translation>
        </message>
        <message>
            <source>Name used in searches.</source>
            <translation>Название для поиска.</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>Примечание</translation>
        </message>
        <message>
            <source>Use of the entry, or the conditions for which it is valid.</source>
            <translation>Для чего применяется или при каких условиях верно.</translation>
        </message>
        <message>
            <source>Note in Russian</source>
            <translation>Примечание по-русски</translation>
        </message>
        <message>
            <source>The note in the Russian window.</source>
            <translation>То же для русского окна.</translation>
        </message>
        <message>
            <source>Sources</source>
            <translation>Источники</translation>
        </message>
        <message>
            <source>Source of each number.</source>
            <translation>Откуда взято каждое число.</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Key of the number.</source>
            <translation>Ключ числа.</translation>
        </message>
        <message>
            <source>Source</source>
            <translation>Источник</translation>
        </message>
        <message>
            <source>Key of the source; empty: an estimate, to be calibrated.</source>
            <translation>Ключ источника; пусто: оценка, подлежит калибровке.</translation>
        </message>
        <message>
            <source>Plausible range</source>
            <translation>Правдоподобный диапазон</translation>
        </message>
        <message>
            <source>Minimum and maximum value to expect.</source>
            <translation>Наименьшее и наибольшее ожидаемое значение.</translation>
        </message>
        <message>
            <source>Temperature</source>
            <translation>Температура</translation>
        </message>
        <message>
            <source>Temperature for which the entry&apos;s conductivity and diffusivity are given.</source>
            <translation>При которой взяты теплопроводность и температуропроводность записи.</translation>
        </message>
        <message>
            <source>Density</source>
            <translation>Плотность</translation>
        </message>
        <message>
            <source>At room temperature.</source>
            <translation>При комнатной температуре.</translation>
        </message>
        <message>
            <source>Conductivity over temperature</source>
            <translation>Теплопроводность от температуры</translation>
        </message>
        <message>
            <source>Rows of temperature and conductivity.</source>
            <translation>Строки: температура и теплопроводность.</translation>
        </message>
        <message>
            <source>Heat capacity over temperature</source>
            <translation>Теплоёмкость от температуры</translation>
        </message>
        <message>
            <source>Rows of temperature and heat capacity.</source>
            <translation>Строки: температура и теплоёмкость.</translation>
        </message>
        <message>
            <source>Key of the source.</source>
            <translation>Ключ источника.</translation>
        </message>
        <message>
            <source>Heat data over temperature</source>
            <translation>Теплофизические данные от температуры</translation>
        </message>
        <message>
            <source>Whether a force in one section deflects the others too; needs the compliance from stiffness and shaft.</source>
            <translation>Отжимает ли сила в одном сечении и остальные; нужна податливость, рассчитанная по жёсткости узлов и валу.</translation>
        </message>
        <message>
            <source>Minimum overlap of a stage</source>
            <translation>Коэф. перекрытия ступени, не менее</translation>
        </message>
        <message>
            <source>Minimum ratio of the wheel width to the table&apos;s advance in one revolution; usually 1.05. Below 1 strips stay uncut.</source>
            <translation>Наименьший коэффициент перекрытия — отношение высоты круга к перемещению стола за оборот заготовки; обычно 1,05. При значении ниже 1 остаются непрошлифованные полосы.</translation>
        </message>
        <message>
            <source>Minimum overlap of the last stage</source>
            <translation>Коэф. перекрытия последней ступени, не менее</translation>
        </message>
        <message>
            <source>same as for every stage</source>
            <translation>как у каждой ступени</translation>
        </message>
        <message>
            <source>Minimum ratio for the last stage, which leaves the surface; usually 2.</source>
            <translation>Наименьший коэффициент перекрытия последней ступени, которая оставляет поверхность; обычно 2.</translation>
        </message>
        <message>
            <source>Minimum steps of a stage</source>
            <translation>Двойных ходов (оборотов) ступени, не менее</translation>
        </message>
        <message>
            <source>Minimum number of double strokes (usually 2) or revolutions (usually 3) of each stage with stock; a spark-out by number is not counted.</source>
            <translation>Наименьшее число двойных ходов (обычно 2) или оборотов (обычно 3) ступени с припуском; выхаживание по числу не считается.</translation>
        </message>
        <message>
            <source>Programmed plunge feed; S_p/n per revolution of the part. Beyond the sources: a stage between others may retract (negative feed) until its stock is off or nothing is cut.</source>
            <translation>Программная врезная подача; S_p/n за оборот заготовки. Сверх источников: ступень между другими может отводить бабку (отрицательная подача), пока не снят её припуск или пока не прекратится съём.</translation>
        </message>
        <message>
            <source>Rows of force and contact stiffness, beyond the sources: 0 50; 200 80.</source>
            <translation>Строки «сила, жёсткость контакта», сверх источников: 0 50; 200 80.</translation>
        </message>
        <message>
            <source>Feeding starts before size</source>
            <translation>Начало подачи до размера</translation>
        </message>
        <message>
            <source>at first touch</source>
            <translation>от касания</translation>
        </message>
        <message>
            <source>Distance from the target radius at which the wheel head&apos;s feed starts. In a batch the wheel touches the nominal blank there: a larger blank is cut deeper at once, a smaller one later.</source>
            <translation>Расстояние от целевого радиуса, с которого начинается подача шлифовальной бабки. В партии — от касания номинальной заготовки: с большей заготовки сразу снимается больше, меньшей круг касается позже.</translation>
        </message>
        <message>
            <source>Minimum and maximum value; equal, a constant.</source>
            <translation>Наименьшее и наибольшее значения; равные — постоянная величина.</translation>
        </message>
        <message>
            <source>Triangular</source>
            <translation>Треугольное</translation>
        </message>
        <message>
            <source>Minimum, most frequent and maximum value.</source>
            <translation>Наименьшее, наиболее частое и наибольшее значения.</translation>
        </message>
        <message>
            <source>Measured</source>
            <translation>Измерения</translation>
        </message>
        <message>
            <source>Values of measured blanks, each as frequent as any other; `sparkout-cli batch --measured` reads them from a CSV.</source>
            <translation>Значения измеренных заготовок, все одинаково частые; `sparkout-cli batch --measured` читает их из CSV.</translation>
        </message>
        <message>
            <source>Contact width</source>
            <translation>Ширина контакта</translation>
        </message>
        <message>
            <source>Traverse: the wheel&apos;s width, from which the widths of cut follow. Plunge: the ground length.</source>
            <translation>С продольной подачей: высота круга, от которой зависит ширина контакта. Врезное: длина обработки.</translation>
        </message>
        <message>
            <source>Stock per side of the last stage</source>
            <translation>Припуск последней ступени на сторону</translation>
        </message>
        <message>
            <source>Minimum and maximum, in cycles of several stages.</source>
            <translation>Наименьший и наибольший, в циклах из нескольких ступеней.</translation>
        </message>
        <message>
            <source>Roughness</source>
            <translation>Шероховатость</translation>
        </message>
        <message>
            <source>Minimum diameter, deviation</source>
            <translation>Наименьший диаметр, отклонение</translation>
        </message>
        <message>
            <source>Maximum diameter, deviation</source>
            <translation>Наибольший диаметр, отклонение</translation>
        </message>
        <message>
            <source>Maximum normal force</source>
            <translation>Наибольшая нормальная сила</translation>
        </message>
        <message>
            <source>Final radii</source>
            <translation>Радиусы в конце цикла</translation>
        </message>
        <message>
            <source>Worst place</source>
            <translation>Худшее место</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>Предел</translation>
        </message>
        <message>
            <source>Margin</source>
            <translation>Запас</translation>
        </message>
        <message>
            <source>Relative margin</source>
            <translation>Относительный запас</translation>
        </message>
        <message>
            <source>Holds</source>
            <translation>Выполнено</translation>
        </message>
        <message>
            <source>How the cycle ended</source>
            <translation>Чем закончился цикл</translation>
        </message>
        <message>
            <source>Cycle time</source>
            <translation>Время цикла</translation>
        </message>
        <message>
            <source>Double strokes or revolutions</source>
            <translation>Двойные ходы или обороты</translation>
        </message>
        <message>
            <source>Double strokes or revolutions by stage</source>
            <translation>Двойные ходы или обороты по ступеням</translation>
        </message>
        <message>
            <source>Zones or sections</source>
            <translation>Зоны или сечения</translation>
        </message>
        <message>
            <source>Maximum power</source>
            <translation>Наибольшая мощность</translation>
        </message>
        <message>
            <source>Requirements</source>
            <translation>Требования</translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation>Варьирование</translation>
        </message>
        <message>
            <source>no input is varied</source>
            <translation>ничего не варьируется</translation>
        </message>
        <message>
            <source>Inputs that the view of sweeps varies over a range.</source>
            <translation>Исходные величины, которые вид «Варьирование» меняет в заданных пределах.</translation>
        </message>
        <message>
            <source>Input</source>
            <translation>Исходная величина</translation>
        </message>
        <message>
            <source>Path of any number of the file that a cycle reads, as `/wheel/dullness` or `/cycle/stages/0/stock_mm`.</source>
            <translation>Путь любого числа файла, от которого зависит цикл, например `/wheel/dullness` или `/cycle/stages/0/stock_mm`.</translation>
        </message>
        <message>
            <source>From</source>
            <translation>От</translation>
        </message>
        <message>
            <source>Minimum value, in the unit of the input.</source>
            <translation>Наименьшее значение, в единицах этой величины.</translation>
        </message>
        <message>
            <source>To</source>
            <translation>До</translation>
        </message>
        <message>
            <source>Maximum value, in the unit of the input.</source>
            <translation>Наибольшее значение, в единицах этой величины.</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Точки</translation>
        </message>
        <message>
            <source>Number of values, both ends included.</source>
            <translation>Число значений, включая оба края.</translation>
        </message>
        <message>
            <source>Spacing</source>
            <translation>Расстановка</translation>
        </message>
        <message>
            <source>Values at equal steps, or at equal ratios of positive values (logarithmic).</source>
            <translation>Равными шагами или, для положительных значений, равными отношениями (логарифмически).</translation>
        </message>
        <message>
            <source>Varied inputs</source>
            <translation>Варьируемые величины</translation>
        </message>
        <message>
            <source>One varied input gives curves, two give a map.</source>
            <translation>Одна даёт кривые, две — карту.</translation>
        </message>
        <message>
            <source>Machine and operator</source>
            <translation>Станок и рабочий</translation>
        </message>
        <message>
            <source>Cost of an hour, in any currency.</source>
            <translation>Сколько стоит час, в любой валюте.</translation>
        </message>
        <message>
            <source>Handling</source>
            <translation>Вспомогательное время</translation>
        </message>
        <message>
            <source>Loading and measuring, in addition to the cycle.</source>
            <translation>Установка и измерение детали сверх цикла.</translation>
        </message>
        <message>
            <source>Dressing time</source>
            <translation>Время правки</translation>
        </message>
        <message>
            <source>Shared by the parts between dressings.</source>
            <translation>Делится на детали между правками.</translation>
        </message>
        <message>
            <source>Wheel worn by a dressing</source>
            <translation>Расход круга на правку</translation>
        </message>
        <message>
            <source>Wheel and diamond, in the same currency.</source>
            <translation>Круг и алмаз, в той же валюте.</translation>
        </message>
        <message>
            <source>as the batch&apos;s dullness grows, otherwise no dressing</source>
            <translation>как растёт затупление в партии, иначе без правки</translation>
        </message>
        <message>
            <source>Levels of the work speed</source>
            <translation>Уровни частоты вращения заготовки</translation>
        </message>
        <message>
            <source>as the machine is set</source>
            <translation>как настроен станок</translation>
        </message>
        <message>
            <source>One value for the whole cycle; its levels as a list, or from, to and step.</source>
            <translation>Одно значение на весь цикл: список либо «от», «до» и шаг.</translation>
        </message>
        <message>
            <source>Levels of the entry dwell</source>
            <translation>Уровни выстоя на входе</translation>
        </message>
        <message>
            <source>Levels of the exit dwell</source>
            <translation>Уровни выстоя на выходе</translation>
        </message>
        <message>
            <source>Spark-outs at the end</source>
            <translation>Выхаживание в конце</translation>
        </message>
        <message>
            <source>Double strokes or revolutions of one more stage without feed that removes the last stock: a list, or from, to and step; 0: without this stage.</source>
            <translation>Двойные ходы или обороты ещё одной ступени без подачи, снимающей последний припуск: список либо «от», «до» и шаг; 0 — без неё.</translation>
        </message>
        <message>
            <source>Radial feed by stage</source>
            <translation>Радиальная подача по ступеням</translation>
        </message>
        <message>
            <source>Minimum and maximum for each stage in order; equal values fix it.</source>
            <translation>Наименьшее и наибольшее для первой ступени, для второй и так далее; два одинаковых числа закрепляют значение.</translation>
        </message>
        <message>
            <source>Axial feed by stage</source>
            <translation>Продольная подача по ступеням</translation>
        </message>
        <message>
            <source>Plunge feed by stage</source>
            <translation>Врезная подача по ступеням</translation>
        </message>
        <message>
            <source>Stock per side by stage</source>
            <translation>Припуск на сторону по ступеням</translation>
        </message>
        <message>
            <source>Cost of a part</source>
            <translation>Стоимость детали</translation>
        </message>
        <message>
            <source>not computed</source>
            <translation>не считается</translation>
        </message>
        <message>
            <source>Minimum Ppk</source>
            <translation>Наименьший Ppk</translation>
        </message>
        <message>
            <source>The verdict calls a cycle fit when the lower 95 % bounds of all Ppk reach it, else conditionally fit.</source>
            <translation>Цикл годен, если нижние 95%-ные границы всех Ppk не меньше этого значения, иначе условно годен.</translation>
        </message>
        <message>
            <source>Maximum share outside</source>
            <translation>Наибольшая доля вне допуска</translation>
        </message>
        <message>
            <source>every part must be good</source>
            <translation>годной должна быть каждая деталь</translation>
        </message>
        <message>
            <source>Share of the parts that may be rejected before the cycle is unfit; when more of them are expected to be out of tolerance, it is conditionally fit.</source>
            <translation>Доля негодных деталей, при превышении которой цикл не годен; если больше этой доли ожидаемая доля вне допуска, цикл условно годен.</translation>
        </message>
        <message>
            <source>Approach</source>
            <translation>Подвод</translation>
        </message>
        <message>
            <source>Time of the wheel's approach to a surface, for each surface.</source>
            <translation>Время подвода круга к поверхности, для каждой из них.</translation>
        </message>
        <message>
            <source>Retreat</source>
            <translation>Отвод</translation>
        </message>
        <message>
            <source>Time of the wheel's retreat from a surface, for each surface.</source>
            <translation>Время отвода круга от поверхности, для каждой из них.</translation>
        </message>
        <message>
            <source>Gauging</source>
            <translation>Измерение</translation>
        </message>
        <message>
            <source>Time of gauging a surface after its cycle, for each surface.</source>
            <translation>Время измерения поверхности после её цикла, для каждой из них.</translation>
        </message>
        <message>
            <source>Table positioning</source>
            <translation>Перемещение стола</translation>
        </message>
        <message>
            <source>Time of moving the table from one surface to the next.</source>
            <translation>Время перемещения стола от одной поверхности к следующей.</translation>
        </message>
        <message>
            <source>Clamping a part and taking it off.</source>
            <translation>Установка и снятие детали.</translation>
        </message>
        <message>
            <source>Main time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>the sum of the cycles</source>
            <translation>сумма циклов</translation>
        </message>
        <message>
            <source>Time in which stock is removed.</source>
            <translation>Время, за которое снимается припуск.</translation>
        </message>
        <message>
            <source>Auxiliary time</source>
            <translation>Вспомогательное время</translation>
        </message>
        <message>
            <source>the sum of the times above</source>
            <translation>сумма выше</translation>
        </message>
        <message>
            <source>Work done for every part besides the cycles.</source>
            <translation>Что делается для каждой детали помимо циклов.</translation>
        </message>
        <message>
            <source>Service and rest</source>
            <translation>Обслуживание и отдых</translation>
        </message>
        <message>
            <source>Serving the machine, and rest, as a share of main and auxiliary time.</source>
            <translation>Обслуживание рабочего места и отдых, доля основного и вспомогательного времени.</translation>
        </message>
        <message>
            <source>Preparation time</source>
            <translation>Подготовительно-заключительное время</translation>
        </message>
        <message>
            <source>Preparing the machine for a batch and clearing it afterwards.</source>
            <translation>Подготовка станка к партии и работы после неё.</translation>
        </message>
        <message>
            <source>Batch size</source>
            <translation>Размер партии</translation>
        </message>
        <message>
            <source>Parts that share the preparation time.</source>
            <translation>Детали, на которые делится подготовительно-заключительное время.</translation>
        </message>
        <message>
            <source>Piece time</source>
            <translation>Штучное время</translation>
        </message>
        <message>
            <source>from the times above</source>
            <translation>из времён выше</translation>
        </message>
        <message>
            <source>The time that a part takes, without its share of the preparation.</source>
            <translation>Время на деталь без её доли подготовительно-заключительного.</translation>
        </message>
        <message>
            <source>Dulling</source>
            <translation>Затупление</translation>
        </message>
        <message>
            <source>the wheel stays as sharp</source>
            <translation>острота круга не меняется</translation>
        </message>
        <message>
            <source>Growth of the dullness per mm³ removed by each millimetre of the wheel's width.</source>
            <translation>На сколько растёт степень затупления с каждым мм³, снятым одним миллиметром высоты круга.</translation>
        </message>
        <message>
            <source>Grinding ratio</source>
            <translation>Коэффициент шлифования</translation>
        </message>
        <message>
            <source>the wheel keeps its diameter</source>
            <translation>диаметр круга не меняется</translation>
        </message>
        <message>
            <source>Volume removed from the parts for each volume of the wheel that wears off.</source>
            <translation>Объём, снятый с деталей, на единицу объёма изношенного круга.</translation>
        </message>
        <message>
            <source>Loading and unloading</source>
            <translation>Установка и снятие детали</translation>
        </message>
        <message>
            <source>Maximum wheel speed</source>
            <translation>Наибольшая скорость круга</translation>
        </message>
        <message>
            <source>Working speed marked on the wheel, which the machine may not exceed.</source>
            <translation>Рабочая скорость, указанная на круге; на станке её превышать нельзя.</translation>
        </message>
        <message>
            <source>Dressing</source>
            <translation>Правка круга</translation>
        </message>
        <message>
            <source>Dressing tool and how it is used, for the operation card.</source>
            <translation>Правящий инструмент и режим правки, для операционной карты.</translation>
        </message>
        <message>
            <source>Coolant</source>
            <translation>СОЖ</translation>
        </message>
        <message>
            <source>Coolant and its concentration, for the operation card.</source>
            <translation>Смазочно-охлаждающая жидкость и её концентрация, для операционной карты.</translation>
        </message>
        <message>
            <source>Maximum part diameter</source>
            <translation>Наибольший диаметр детали</translation>
        </message>
        <message>
            <source>Diameter up to which the machine grinds.</source>
            <translation>Диаметр, до которого шлифует станок.</translation>
        </message>
        <message>
            <source>Maximum part length</source>
            <translation>Наибольшая длина детали</translation>
        </message>
        <message>
            <source>Length that the machine accepts.</source>
            <translation>Длина детали, которую принимает станок.</translation>
        </message>
        <message>
            <source>Maximum wheel diameter</source>
            <translation>Наибольший диаметр круга</translation>
        </message>
        <message>
            <source>Diameter of a new wheel that the machine accepts.</source>
            <translation>Диаметр нового круга, который принимает станок.</translation>
        </message>
        <message>
            <source>Range of wheel widths</source>
            <translation>Диапазон высоты круга</translation>
        </message>
        <message>
            <source>Minimum and maximum width that the wheel&apos;s flanges hold.</source>
            <translation>Наименьшая и наибольшая высота круга, которую зажимают фланцы.</translation>
        </message>
        <message>
            <source>Diameter of the wheel seat</source>
            <translation>Посадочный диаметр круга</translation>
        </message>
        <message>
            <source>Bore of a wheel that fits; it is compared with the one of the marking, 305 in 600×63×305.</source>
            <translation>Отверстие круга, который подходит; сравнивается с отверстием в маркировке: 305 в 600×63×305.</translation>
        </message>
        <message>
            <source>any bore fits</source>
            <translation>подходит любое отверстие</translation>
        </message>
        <message>
            <source>Gap begins at</source>
            <translation>Паз начинается под углом</translation>
        </message>
        <message>
            <source>Angle of the gap's first edge, counted as the radii are, from radius 0 on.</source>
            <translation>Угол первой кромки паза; отсчитывается, как и радиусы, от радиуса 0.</translation>
        </message>
        <message>
            <source>Gap width</source>
            <translation>Ширина паза</translation>
        </message>
        <message>
            <source>Angle from edge to edge; of a keyway of width w about 115°·w/d. The radii within are not ground.</source>
            <translation>Угол от кромки до кромки; у шпоночного паза шириной w — около 115°·w/d. Радиусы внутри не шлифуются.</translation>
        </message>
        <message>
            <source>Gaps of the surface</source>
            <translation>Пазы поверхности</translation>
        </message>
        <message>
            <source>Keyways, splines, flats: ranges of angle without a surface, the same all along the ground length. Their radii are not ground, gauged or judged.</source>
            <translation>Шпоночные пазы, шлицы, лыски: участки угла без поверхности, одинаковые по всей длине шлифования. Их радиусы не шлифуются, не измеряются и не оцениваются.</translation>
        </message>
        <message>
            <source>Gauge spans the gaps</source>
            <translation>Прибор перекрывает пазы</translation>
        </message>
        <message>
            <source>A gauge for interrupted surfaces, with wide contacts or a reading held over the gaps. Any other gauge drops into the gaps, so that only its maximum diameter (in a bore the minimum) can be used.</source>
            <translation>Прибор для прерывистых поверхностей: с широкими наконечниками или с удержанием показания над пазами. Любой другой проваливается в пазы, и пригоден только наибольший диаметр (в отверстии — наименьший).</translation>
        </message>
        <message>
            <source>Out-of-roundness of the blank: ellipse R = pq/√((q·cos φ)² + (p·sin φ)²), eccentric circle, n lobes, or a measured profile.</source>
            <translation>Отклонение заготовки от круглости: овальность R = pq/√((q·cos φ)² + (p·sin φ)²), эксцентричная окружность, огранка из n граней или измеренный профиль.</translation>
        </message>
        <message>
            <source>Sections in a zone</source>
            <translation>Сечений в зоне</translation>
        </message>
        <message>
            <source>Sections at the middles of equal slices of each zone. They all go through its steps, each with its own compliance if that is computed; size and form are judged in all of them.</source>
            <translation>Сечения в серединах равных участков каждой зоны. Все проходят её этапы, каждое со своей податливостью, если она вычисляется; размер и форма оцениваются во всех.</translation>
        </message>
        <message>
            <source>Measurements</source>
            <translation>Измерения</translation>
        </message>
        <message>
            <source>Part number</source>
            <translation>Номер детали</translation>
        </message>
        <message>
            <source>Number or name of the measured part.</source>
            <translation>Номер или название измеренной детали.</translation>
        </message>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>Zone or section where it was measured, counted from 0 at the headstock.</source>
            <translation>Место измерения: зона или сечение, счёт с 0 от передней бабки.</translation>
        </message>
        <message>
            <source>Measured diameters</source>
            <translation>Измеренные диаметры</translation>
        </message>
        <message>
            <source>One diameter, or several around the part, whose mean counts.</source>
            <translation>Один диаметр или несколько по окружности; в счёт идёт их среднее.</translation>
        </message>
        <message>
            <source>Measured roundness</source>
            <translation>Измеренное отклонение от круглости</translation>
        </message>
        <message>
            <source>Roundness deviation of this section.</source>
            <translation>Отклонение от круглости в этом сечении.</translation>
        </message>
        <message>
            <source>Measured runout</source>
            <translation>Измеренное биение</translation>
        </message>
        <message>
            <source>Radial runout of this section about the centres.</source>
            <translation>Радиальное биение этого сечения относительно центров.</translation>
        </message>
        <message>
            <source>Measured cylindricity</source>
            <translation>Измеренное отклонение от цилиндричности</translation>
        </message>
        <message>
            <source>Cylindricity deviation of the part, stated once in any of its zones or sections.</source>
            <translation>Отклонение детали от цилиндричности; указывается один раз в любой её зоне или сечении.</translation>
        </message>
        <message>
            <source>Measured roughness</source>
            <translation>Измеренная шероховатость</translation>
        </message>
        <message>
            <source>Arithmetic mean roughness Ra along the axis.</source>
            <translation>Среднее арифметическое отклонение профиля Ra вдоль оси.</translation>
        </message>
        <message>
            <source>When the part was ground or measured.</source>
            <translation>Когда деталь была отшлифована или измерена.</translation>
        </message>
        <message>
            <source>Anything worth knowing about the data.</source>
            <translation>Всё, что важно знать о данных.</translation>
        </message>
        <message>
            <source>Quantity</source>
            <translation>Показатель</translation>
        </message>
        <message>
            <source>Quantity recorded over time.</source>
            <translation>Что записано во времени.</translation>
        </message>
        <message>
            <source>where the gauge measures</source>
            <translation>там, где измеряет прибор</translation>
        </message>
        <message>
            <source>Zone or section where a size was recorded, counted from 0.</source>
            <translation>Где записан размер: зона или сечение, счёт с 0.</translation>
        </message>
        <message>
            <source>Power to current</source>
            <translation>Мощность на единицу тока</translation>
        </message>
        <message>
            <source>not known, or the trace is not a current</source>
            <translation>неизвестно, или запись не является током</translation>
        </message>
        <message>
            <source>Power of the wheel spindle per ampere of its current.</source>
            <translation>Мощность шпинделя круга на один ампер его тока.</translation>
        </message>
        <message>
            <source>Idle value</source>
            <translation>Значение холостого хода</translation>
        </message>
        <message>
            <source>not known</source>
            <translation>неизвестно</translation>
        </message>
        <message>
            <source>Power or current of the spindle while nothing is cut, in the unit of the values.</source>
            <translation>Мощность или ток шпинделя без резания, в единицах записи.</translation>
        </message>
        <message>
            <source>Times</source>
            <translation>Моменты времени</translation>
        </message>
        <message>
            <source>Times of the samples in order, none earlier than the one before it; at most 20,000.</source>
            <translation>Моменты отсчётов, каждый не раньше предыдущего; не более 20 000.</translation>
        </message>
        <message>
            <source>Values</source>
            <translation>Значения</translation>
        </message>
        <message>
            <source>One value for each time: a size in mm of diameter from any zero, a power in kW, a current in A, a force in N.</source>
            <translation>Одно значение на каждый момент: размер в мм диаметра от любого нуля, мощность в кВт, ток в А, сила в Н.</translation>
        </message>
        <message>
            <source>Source file</source>
            <translation>Исходный файл</translation>
        </message>
        <message>
            <source>Name of the file the samples were read from.</source>
            <translation>Имя файла, из которого прочитаны отсчёты.</translation>
        </message>
        <message>
            <source>Digest of the source</source>
            <translation>Контрольная сумма источника</translation>
        </message>
        <message>
            <source>SHA-256 of that file, as hexadecimal digits.</source>
            <translation>SHA-256 этого файла шестнадцатеричными цифрами.</translation>
        </message>
        <message>
            <source>Samples of the source</source>
            <translation>Отсчётов в источнике</translation>
        </message>
        <message>
            <source>Number of samples in that file; if they exceeded the limit, they were reduced to means.</source>
            <translation>Сколько отсчётов в этом файле; лишние сведены в средние.</translation>
        </message>
        <message>
            <source>Quantity that the statistics describe.</source>
            <translation>К чему относится статистика.</translation>
        </message>
        <message>
            <source>Number of parts</source>
            <translation>Число деталей</translation>
        </message>
        <message>
            <source>Number of parts that were measured.</source>
            <translation>Сколько деталей измерено.</translation>
        </message>
        <message>
            <source>Mean</source>
            <translation>Среднее</translation>
        </message>
        <message>
            <source>Mean of the parts; of a diameter its mean deviation from the nominal one.</source>
            <translation>Среднее по деталям; для диаметра — среднее отклонение от номинального.</translation>
        </message>
        <message>
            <source>Half width of the interval</source>
            <translation>Полуширина интервала</translation>
        </message>
        <message>
            <source>Half the width of the confidence interval of the mean: the value after ±.</source>
            <translation>Половина ширины доверительного интервала среднего: то, что стоит после ±.</translation>
        </message>
        <message>
            <source>Confidence</source>
            <translation>Доверительная вероятность</translation>
        </message>
        <message>
            <source>Confidence of that interval.</source>
            <translation>Доверительная вероятность этого интервала.</translation>
        </message>
        <message>
            <source>Standard deviation</source>
            <translation>Стандартное отклонение</translation>
        </message>
        <message>
            <source>Standard deviation of the parts. Where it is not stated, it follows from the interval of the mean.</source>
            <translation>Стандартное отклонение деталей. Если не указано, оно следует из интервала среднего.</translation>
        </message>
        <message>
            <source>Minimum value</source>
            <translation>Наименьшее значение</translation>
        </message>
        <message>
            <source>Minimum value of all parts.</source>
            <translation>Наименьшее значение по всем деталям.</translation>
        </message>
        <message>
            <source>Maximum value</source>
            <translation>Наибольшее значение</translation>
        </message>
        <message>
            <source>Maximum value of all parts.</source>
            <translation>Наибольшее значение по всем деталям.</translation>
        </message>
        <message>
            <source>Calibrated input</source>
            <translation>Откалиброванная величина</translation>
        </message>
        <message>
            <source>Path of the input whose value was found.</source>
            <translation>Путь исходной величины, значение которой найдено.</translation>
        </message>
        <message>
            <source>Value found</source>
            <translation>Найденное значение</translation>
        </message>
        <message>
            <source>Value that was found, in the unit of the input.</source>
            <translation>Найденное значение в единицах этой величины.</translation>
        </message>
        <message>
            <source>Lower end</source>
            <translation>Нижняя граница</translation>
        </message>
        <message>
            <source>Lower end of its 95 % interval.</source>
            <translation>Нижняя граница его интервала 95 %.</translation>
        </message>
        <message>
            <source>Upper end</source>
            <translation>Верхняя граница</translation>
        </message>
        <message>
            <source>Upper end of its 95 % interval.</source>
            <translation>Верхняя граница его интервала 95 %.</translation>
        </message>
        <message>
            <source>Data</source>
            <translation>Данные</translation>
        </message>
        <message>
            <source>Data used for the calibration.</source>
            <translation>По каким данным откалибровано.</translation>
        </message>
        <message>
            <source>Measured values</source>
            <translation>Измеренных значений</translation>
        </message>
        <message>
            <source>Number of measured values used.</source>
            <translation>На скольких измеренных значениях оно основано.</translation>
        </message>
        <message>
            <source>Date</source>
            <translation>Дата</translation>
        </message>
        <message>
            <source>Date and time of the calibration, ISO 8601.</source>
            <translation>Когда откалибровано, ISO 8601.</translation>
        </message>
        <message>
            <source>Measured parts</source>
            <translation>Измеренные детали</translation>
        </message>
        <message>
            <source>A row for each zone or section of a part.</source>
            <translation>Строка на каждую зону или сечение детали.</translation>
        </message>
        <message>
            <source>Measured traces</source>
            <translation>Записи по времени</translation>
        </message>
        <message>
            <source>Quantities recorded over the time of a cycle.</source>
            <translation>Величины, записанные за время цикла.</translation>
        </message>
        <message>
            <source>Measured statistics</source>
            <translation>Статистика измерений</translation>
        </message>
        <message>
            <source>Statistics of parts that are not listed.</source>
            <translation>Статистика деталей, не перечисленных поштучно.</translation>
        </message>
        <message>
            <source>Calibrations</source>
            <translation>Калибровки</translation>
        </message>
        <message>
            <source>Inputs whose values were found from measurements.</source>
            <translation>Исходные величины, значения которых найдены по измерениям.</translation>
        </message>
        <message>
            <source>nothing is measured</source>
            <translation>ничего не измерено</translation>
        </message>
        <message>
            <source>Measured parts and traces to compare with the prediction, and the inputs calibrated on them.</source>
            <translation>Измеренные детали и записи, с которыми сравнивается прогноз, и то, что по ним откалибровано.</translation>
        </message>
        <message>
            <source>T_o</source>
            <translation>T_о</translation>
        </message>
        <message>
            <source>T_a</source>
            <translation>T_в</translation>
        </message>
        <message>
            <source>T_p</source>
            <translation>T_пз</translation>
        </message>
        <message>
            <source>T_1</source>
            <translation>T_шт</translation>
        </message>
        <message>
            <source>n·(approach + retreat + gauging) + (n − 1)·positioning + handling</source>
            <translation>n·(подвод + отвод + измерение) + (n − 1)·перемещение + установка и снятие</translation>
        </message>
        <message>
            <source>(T_o + T_a)·(1 + service/100)</source>
            <translation>(T_о + T_в)·(1 + обслуживание/100)</translation>
        </message>
        <message>
            <source>Levels follow the answer</source>
            <translation>Уровни уточняются по ответу</translation>
        </message>
        <message>
            <source>Levels of the feeds are added around the answer, and beyond the edge of the grid if the answer lies there and the machine allows it; then the grid is searched again.</source>
            <translation>Уровни подач добавляются вокруг ответа, а если он стоит на краю сетки и станок допускает больше, то и за краем; затем поиск повторяется.</translation>
        </message>
        <message>
            <source>Contact factor</source>
            <translation>Коэффициент контакта</translation>
        </message>
        <message>
            <source>Factor of the number of cutting grains in the contact, of the conditions of grinding; to be calibrated.</source>
            <translation>Коэффициент числа режущих зёрен в контакте, зависит от условий шлифования; подлежит калибровке.</translation>
        </message>
        <message>
            <source>Cutting grains per length</source>
            <translation>Режущих зёрен на длине</translation>
        </message>
        <message>
            <source>Cutting grains on a millimetre of the wheel&apos;s circumference; they set the thickness of a chip.</source>
            <translation>Режущих зёрен на миллиметре окружности круга; от них зависит толщина среза одним зерном.</translation>
        </message>
        <message>
            <source>Shear angle</source>
            <translation>Угол сдвига</translation>
        </message>
        <message>
            <source>Angle of the plane in which a grain&apos;s chip shears.</source>
            <translation>Угол плоскости, в которой сдвигается стружка одного зерна.</translation>
        </message>
        <message>
            <source>Width of a grain&apos;s cut</source>
            <translation>Ширина среза зерном</translation>
        </message>
        <message>
            <source>chips make up the metal removed</source>
            <translation>срезы вместе — снятый металл</translation>
        </message>
        <message>
            <source>Width of the cut of one grain. Where it is not given, it is chosen so that the chips add up to the metal removed.</source>
            <translation>Ширина среза одним зерном. Если не задана, она такова, что срезы зёрен вместе составляют снятый металл.</translation>
        </message>
        <message>
            <source>Length of a wear flat</source>
            <translation>Длина площадки износа</translation>
        </message>
        <message>
            <source>from the dullness</source>
            <translation>по затуплению</translation>
        </message>
        <message>
            <source>Length of the wear flat of one grain; with it the dullness follows from the recipe.</source>
            <translation>Длина площадки износа одного зерна; с ней затупление следует из рецептуры.</translation>
        </message>
        <message>
            <source>Force by the wheel&apos;s recipe</source>
            <translation>Сила по рецептуре круга</translation>
        </message>
        <message>
            <source>by the law&apos;s coefficients</source>
            <translation>по коэффициентам закона силы</translation>
        </message>
        <message>
            <source>The cutting force from grain size and structure, summed over the grains in contact, instead of the law for all chips together.</source>
            <translation>Сила резания по зернистости и структуре, суммированная по зёрнам в контакте, вместо закона, в котором срезы вместе составляют снятый металл.</translation>
        </message>
        <message>
            <source>Operation card</source>
            <translation>Операционная карта</translation>
        </message>
        <message>
            <source>Entries in the head of the operation card in addition to the inputs of the cycle.</source>
            <translation>Что стоит в заголовке операционной карты помимо исходных данных цикла.</translation>
        </message>
        <message>
            <source>The number of the drawing.</source>
            <translation>Номер чертежа.</translation>
        </message>
        <message>
            <source>Document number</source>
            <translation>Обозначение документа</translation>
        </message>
        <message>
            <source>Designation of the operation card.</source>
            <translation>Обозначение операционной карты.</translation>
        </message>
        <message>
            <source>Operation number</source>
            <translation>Номер операции</translation>
        </message>
        <message>
            <source>Number of the operation in the part&apos;s route.</source>
            <translation>Номер операции в маршруте изготовления детали.</translation>
        </message>
        <message>
            <source>Letter</source>
            <translation>Литера</translation>
        </message>
        <message>
            <source>Letter of the document by GOST 3.1102, for example A.</source>
            <translation>Литера, присвоенная документу по ГОСТ 3.1102, например А.</translation>
        </message>
        <message>
            <source>NC program</source>
            <translation>Программа ЧПУ</translation>
        </message>
        <message>
            <source>Designation of the program of the numerical control.</source>
            <translation>Обозначение управляющей программы ЧПУ.</translation>
        </message>
        <message>
            <source>Mass of the part</source>
            <translation>Масса детали</translation>
        </message>
        <message>
            <source>Mass by the drawing, or by the steps of the shaft as solid steel.</source>
            <translation>Масса по чертежу или по ступеням вала как сплошной стали.</translation>
        </message>
        <message>
            <source>Profile and sizes</source>
            <translation>Профиль и размеры заготовки</translation>
        </message>
        <message>
            <source>Profile and sizes of the blank, for example round bar ⌀50 × 325.</source>
            <translation>Профиль и размеры заготовки, например круг ⌀50 × 325.</translation>
        </message>
        <message>
            <source>Mass of the blank</source>
            <translation>Масса заготовки</translation>
        </message>
        <message>
            <source>Mass of the blank that the part is made of.</source>
            <translation>Масса заготовки, из которой делают деталь.</translation>
        </message>
        <message>
            <source>not given</source>
            <translation>не задано</translation>
        </message>
        <message>
            <source>Designation of the part</source>
            <translation>Обозначение изделия</translation>
        </message>
        <message>
            <source>Further stock by zone</source>
            <translation>Добавка припуска по зонам</translation>
        </message>
        <message>
            <source>Further runout by zone</source>
            <translation>Добавка биения по зонам</translation>
        </message>
        <message>
            <source>Compliance factor by zone</source>
            <translation>Множитель податливости по зонам</translation>
        </message>
        <message>
            <source>the same everywhere</source>
            <translation>везде одинаково</translation>
        </message>
        <message>
            <source>1 everywhere</source>
            <translation>везде 1</translation>
        </message>
        <message>
            <source>Difference of the stock per side of each zone or section, in their order, from that of the part.</source>
            <translation>На сколько припуск на сторону каждой зоны или сечения, по порядку, больше припуска детали или меньше его.</translation>
        </message>
        <message>
            <source>Difference of the initial runout of each zone or section, in their order, from that of the part.</source>
            <translation>На сколько исходное биение каждой зоны или сечения, по порядку, больше биения детали или меньше его.</translation>
        </message>
        <message>
            <source>Multiplies the compliance of each zone or section, in their order, given or computed; not with coupled sections.</source>
            <translation>Умножает податливость каждой зоны или сечения, по порядку, заданную или вычисленную; не при связанных сечениях.</translation>
        </message>
        <message>
            <source>Minimum and maximum difference of each zone or section from the stock of the part, in their order; they scatter independently and uniformly. Two equal values are a constant.</source>
            <translation>Наименьшее и наибольшее отличие припуска каждой зоны или сечения от припуска детали, по порядку; каждое рассеивается само по себе, равномерно. Два одинаковых числа — постоянная.</translation>
        </message>
        <message>
            <source>Minimum and maximum difference of each zone or section from the initial runout of the part, in their order; they scatter independently and uniformly. Two equal values are a constant.</source>
            <translation>Наименьшее и наибольшее отличие исходного биения каждой зоны или сечения от биения детали, по порядку; каждое рассеивается само по себе, равномерно. Два одинаковых числа — постоянная.</translation>
        </message>
        <message>
            <source>Minimum and maximum factor on the compliance of each zone or section, in their order; they scatter independently and uniformly. Two equal values are a constant.</source>
            <translation>Наименьший и наибольший множитель податливости каждой зоны или сечения, по порядку; каждый рассеивается сам по себе, равномерно. Два одинаковых числа — постоянная.</translation>
        </message>
        <message>
            <source>Exponent of dulling</source>
            <translation>Показатель роста затупления</translation>
        </message>
        <message>
            <source>1: the dullness grows evenly. Below 1 it grows most just after dressing, above 1 towards the end; the dulling is then counted per mm² to this power.</source>
            <translation>1 — затупление растёт равномерно. Меньше 1 — быстрее всего сразу после правки, больше 1 — к концу; коэффициент затупления отнесён тогда к мм² в этой степени.</translation>
        </message>
        <message>
            <source>Maximum margin within a time</source>
            <translation>Наибольший запас за время</translation>
        </message>
        <message>
            <source>the minimum time is searched</source>
            <translation>ищется наименьшее время</translation>
        </message>
        <message>
            <source>Rotation ratio off a whole number</source>
            <translation>Отличие отношения частот от целого</translation>
        </message>
        <message>
            <source>any; 0.05 if work speeds are searched and the wheel's runout is not given</source>
            <translation>любое; 0,05, если частота вращения заготовки ищется, а биение круга не задано</translation>
        </message>
        <message>
            <source>Minimum distance of n_k/n, the revolutions of the wheel for one of the work, from a whole number: the search leaves out work speeds that are nearer to one, at which waves of the wheel print onto one another.</source>
            <translation>Наименьшее отличие n_к/n, числа оборотов круга на один оборот заготовки, от целого числа: поиск не рассматривает частоты вращения заготовки, при которых оно меньше и волны от круга ложатся одна на другую.</translation>
        </message>
        <message>
            <source>The search then returns the cycle farthest from its limits within this machining time: the one with the largest minimum margin of all requirements, each as a share of its limit.</source>
            <translation>Тогда поиск находит цикл с основным временем не больше заданного, который дальше всех от пределов: его наименьший запас по всем требованиям, каждый в долях своего предела, наибольший.</translation>
        </message>
        <message>
            <source>For the minimum cost with a wheel that wears, the search finds this number, and the value given is its maximum.</source>
            <translation>При поиске наименьшей стоимости с изнашивающимся кругом его находит поиск, а это — наибольшее допустимое.</translation>
        </message>
        <message>
            <source>Shown beside the time; the minimum is searched if it is the objective.</source>
            <translation>Указывается рядом со временем; наименьшая ищется, если это цель поиска.</translation>
        </message>
        <message>
            <source>Objective</source>
            <translation>Цель поиска</translation>
        </message>
        <message>
            <source>Cost and wheel life are searched over the parts from one dressing to the next: the cycle is fit for all of them, with the wheel as worn by the parts. The minimum cost needs the cost of a part.</source>
            <translation>Стоимость и стойкость круга ищутся по деталям от правки до правки: цикл годен для каждой из них, с кругом, каким его делает износ, заданный у детали. Для наименьшей стоимости нужна стоимость детали.</translation>
        </message>
        <message>
            <source>Path of an input, or of all below it, as `/wheel/dullness` or `/cycle`. Of several that name an input the longest applies.</source>
            <translation>Путь исходной величины или всех под ним, например `/wheel/dullness` или `/cycle`. Если величину называют несколько путей, действует самый длинный.</translation>
        </message>
        <message>
            <source>Access</source>
            <translation>Доступ</translation>
        </message>
        <message>
            <source>Text</source>
            <translation>Текст</translation>
        </message>
        <message>
            <source>Price</source>
            <translation>Цена</translation>
        </message>
        <message>
            <source>Points of the step that a student loses by using it.</source>
            <translation>Сколько баллов шага теряет студент, взявший подсказку.</translation>
        </message>
        <message>
            <source>View</source>
            <translation>Вид</translation>
        </message>
        <message>
            <source>Name of the view as for `--view`; not given: the current view stays.</source>
            <translation>По имени для `--view`; не задан — остаётся открытый вид.</translation>
        </message>
        <message>
            <source>as it is</source>
            <translation>как есть</translation>
        </message>
        <message>
            <source>Stage</source>
            <translation>Ступень</translation>
        </message>
        <message>
            <source>Double stroke or revolution</source>
            <translation>Двойной ход или оборот</translation>
        </message>
        <message>
            <source>Step of the double stroke</source>
            <translation>Этап двойного хода</translation>
        </message>
        <message>
            <source>Task</source>
            <translation>Задание</translation>
        </message>
        <message>
            <source>Number of the surface that the step is about, from 1.</source>
            <translation>О какой поверхности шаг; счёт от 1.</translation>
        </message>
        <message>
            <source>Values put into the project when the step begins.</source>
            <translation>Что задаётся в проекте, когда шаг начинается.</translation>
        </message>
        <message>
            <source>Other inputs</source>
            <translation>Прочие исходные данные</translation>
        </message>
        <message>
            <source>The access of students to inputs that are not named.</source>
            <translation>Что студент может делать с данными, которые не названы.</translation>
        </message>
        <message>
            <source>Hidden</source>
            <translation>Скрыто</translation>
        </message>
        <message>
            <source>Views, panels and commands that are hidden in this step.</source>
            <translation>Виды, панели и команды, которых на этом шаге нет.</translation>
        </message>
        <message>
            <source>Goal</source>
            <translation>Цель</translation>
        </message>
        <message>
            <source>Exactly one kind.</source>
            <translation>Ровно одного вида.</translation>
        </message>
        <message>
            <source>Hints</source>
            <translation>Подсказки</translation>
        </message>
        <message>
            <source>In the order in which they may be taken.</source>
            <translation>В том порядке, в каком их можно брать.</translation>
        </message>
        <message>
            <source>Moment shown</source>
            <translation>Показываемый момент</translation>
        </message>
        <message>
            <source>the window stays as it is</source>
            <translation>окно остаётся как есть</translation>
        </message>
        <message>
            <source>Aim</source>
            <translation>Цель работы</translation>
        </message>
        <message>
            <source>Theory</source>
            <translation>Теория</translation>
        </message>
        <message>
            <source>Steps</source>
            <translation>Шаги</translation>
        </message>
        <message>
            <source>Variants</source>
            <translation>Варианты</translation>
        </message>
        <message>
            <source>all students have the same project</source>
            <translation>у всех студентов один проект</translation>
        </message>
        <message>
            <source>Only in the teacher&apos;s file.</source>
            <translation>Только в файле преподавателя.</translation>
        </message>
        <message>
            <source>Guide for the teacher</source>
            <translation>Указания преподавателю</translation>
        </message>
        <message>
            <source>none is printed</source>
            <translation>не печатаются</translation>
        </message>
        <message>
            <source>Minimum margin</source>
            <translation>Наименьший запас</translation>
        </message>
        <message>
            <source>Relative margin that the worst requirement must have.</source>
            <translation>Относительный запас, который должен остаться у худшего требования.</translation>
        </message>
        <message>
            <source>For every stock</source>
            <translation>Для всех припусков</translation>
        </message>
        <message>
            <source>Under gauge control the requirements must be met for every stock within one infeed of the last stage, as in the verdict; otherwise for the part that is run.</source>
            <translation>При управлении от прибора требования должны выполняться для всех припусков в пределах одной подачи последней ступени, как их оценивает заключение; иначе для рассчитанной детали.</translation>
        </message>
        <message>
            <source>Below</source>
            <translation>Не дольше</translation>
        </message>
        <message>
            <source>it follows from the proved best of each variant</source>
            <translation>следует из доказанного лучшего времени варианта</translation>
        </message>
        <message>
            <source>Maximum excess over the best</source>
            <translation>Превышение лучшего, не более</translation>
        </message>
        <message>
            <source>a time is given</source>
            <translation>задано время</translation>
        </message>
        <message>
            <source>Relative to the quickest cycle of the project&apos;s grid that meets every requirement, proved by the search for each variant.</source>
            <translation>От самого быстрого цикла на сетке проекта, выполняющего все требования: его доказывает поиск для каждого варианта.</translation>
        </message>
        <message>
            <source>Every requirement must be met too</source>
            <translation>И все требования выполняются</translation>
        </message>
        <message>
            <source>Figure</source>
            <translation>Показатель</translation>
        </message>
        <message>
            <source>In the unit of the figure.</source>
            <translation>В единице показателя.</translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation>Допуск</translation>
        </message>
        <message>
            <source>In both directions (±).</source>
            <translation>±.</translation>
        </message>
        <message>
            <source>±, in the quantity's unit.</source>
            <translation>±, в единице показателя.</translation>
        </message>
        <message>
            <source>Tolerance, relative</source>
            <translation>Допуск относительный</translation>
        </message>
        <message>
            <source>Relative to the engine&apos;s value. The larger of the two tolerances applies.</source>
            <translation>От рассчитанного значения. Действует больший из двух допусков.</translation>
        </message>
        <message>
            <source>Read off the run</source>
            <translation>Читается по результату</translation>
        </message>
        <message>
            <source>Otherwise it is predicted before the run, and nothing is shown until then.</source>
            <translation>Иначе предсказывается до расчёта, и до тех пор ничего не показано.</translation>
        </message>
        <message>
            <source>Along</source>
            <translation>Вдоль чего</translation>
        </message>
        <message>
            <source>At</source>
            <translation>Где сравнивается</translation>
        </message>
        <message>
            <source>Places where the drawn curve is compared: double strokes, revolutions and stages from 1, sections from 0, zones as 0, 1, 2.</source>
            <translation>В каких местах сравнивается кривая: двойные ходы, обороты и ступени от 1, сечения от 0, зоны как 0, 1, 2.</translation>
        </message>
        <message>
            <source>Share within the tolerance</source>
            <translation>Доля мест в допуске</translation>
        </message>
        <message>
            <source>Share of the places where it is compared.</source>
            <translation>Из мест, где кривая сравнивается.</translation>
        </message>
        <message>
            <source>Tolerance of the order</source>
            <translation>Одинаковы в пределах</translation>
        </message>
        <message>
            <source>Places whose values are no further apart may stand in either order.</source>
            <translation>Места, значения в которых отличаются не больше, могут стоять в любом порядке.</translation>
        </message>
        <message>
            <source>Right</source>
            <translation>Верный</translation>
        </message>
        <message>
            <source>Options</source>
            <translation>Варианты ответа</translation>
        </message>
        <message>
            <source>A student&apos;s file does not state which options are right.</source>
            <translation>В файле студента не сказано, какие из них верны.</translation>
        </message>
        <message>
            <source>Minimum length</source>
            <translation>Наименьшая длина</translation>
        </message>
        <message>
            <source>Least number of letters of an answer.</source>
            <translation>Сколько букв должно быть в ответе.</translation>
        </message>
        <message>
            <source>Requirements are met</source>
            <translation>Требования выполнены</translation>
        </message>
        <message>
            <source>not asked</source>
            <translation>не спрашивается</translation>
        </message>
        <message>
            <source>The cycle ends by itself and every requirement is met.</source>
            <translation>Цикл заканчивается сам, и все требования выполняются.</translation>
        </message>
        <message>
            <source>Quick enough</source>
            <translation>Время цикла</translation>
        </message>
        <message>
            <source>The cycle takes less than a time.</source>
            <translation>Цикл не дольше заданного времени.</translation>
        </message>
        <message>
            <source>A figure of the run has a value, within a tolerance.</source>
            <translation>Показатель расчёта равен заданному в пределах допуска.</translation>
        </message>
        <message>
            <source>Number predicted</source>
            <translation>Прогноз числа</translation>
        </message>
        <message>
            <source>A figure is predicted before the run.</source>
            <translation>Показатель предсказывают до расчёта.</translation>
        </message>
        <message>
            <source>Curve predicted</source>
            <translation>Прогноз кривой</translation>
        </message>
        <message>
            <source>A curve is drawn before the run.</source>
            <translation>Кривая рисуется до расчёта.</translation>
        </message>
        <message>
            <source>Order predicted</source>
            <translation>Прогноз порядка</translation>
        </message>
        <message>
            <source>Zones or sections are put in order before the run.</source>
            <translation>Зоны или сечения ставятся по порядку до расчёта.</translation>
        </message>
        <message>
            <source>Choice</source>
            <translation>Выбор</translation>
        </message>
        <message>
            <source>All right options are chosen and no other.</source>
            <translation>Выбраны все верные ответы и никакие другие.</translation>
        </message>
        <message>
            <source>Answer in words</source>
            <translation>Ответ словами</translation>
        </message>
        <message>
            <source>It is kept for the teacher, who gives the points.</source>
            <translation>Хранится для преподавателя, он ставит баллы.</translation>
        </message>
        <message>
            <source>Name of the quantity; it contains the unit.</source>
            <translation>По имени; единица — в нём.</translation>
        </message>
        <message>
            <source>none is needed</source>
            <translation>не нужна</translation>
        </message>
        <message>
            <source>A section by its number from 0, as in a project file.</source>
            <translation>Сечение — номером от 0, как в файле проекта.</translation>
        </message>
        <message>
            <source>none is needed, or the last one</source>
            <translation>не нужна или последняя</translation>
        </message>
        <message>
            <source>Counted from 1.</source>
            <translation>Счёт от 1.</translation>
        </message>
        <message>
            <source>the last one of the stage</source>
            <translation>последний на ступени</translation>
        </message>
        <message>
            <source>Number within the cycle, counted from 1.</source>
            <translation>В цикле, счёт от 1.</translation>
        </message>
        <message>
            <source>In a traverse cycle.</source>
            <translation>При шлифовании с продольной подачей.</translation>
        </message>
        <message>
            <source>Its path in a project file, as `/wheel/dullness` or `/cycle/stages/0/stock_mm`.</source>
            <translation>Путь в файле проекта, например `/wheel/dullness` или `/cycle/stages/0/stock_mm`.</translation>
        </message>
        <message>
            <source>Number</source>
            <translation>Число</translation>
        </message>
        <message>
            <source>the text</source>
            <translation>текст</translation>
        </message>
        <message>
            <source>In the unit of the input.</source>
            <translation>В единице исходной величины.</translation>
        </message>
        <message>
            <source>A choice by its key, or a name.</source>
            <translation>Ключ из списка или название.</translation>
        </message>
        <message>
            <source>In Russian</source>
            <translation>По-русски</translation>
        </message>
        <message>
            <source>With the tags of the help&apos;s pages that fetch nothing; formulas stand in `&lt;p class=&quot;formula&quot;&gt;`.</source>
            <translation>С тегами страниц справки, которые ничего не загружают; формулы стоят в `&lt;p class=&quot;formula&quot;&gt;`.</translation>
        </message>
        <message>
            <source>In English</source>
            <translation>По-английски</translation>
        </message>
        <message>
            <source>If one language is missing, the other is shown.</source>
            <translation>То же. Если одного языка нет, показывается другой.</translation>
        </message>
        <message>
            <source>Question</source>
            <translation>Вопрос</translation>
        </message>
        <message>
            <source>Answer</source>
            <translation>Ответ</translation>
        </message>
        <message>
            <source>Frequent mistakes of students, and how to respond to them.</source>
            <translation>В чём студенты часто ошибаются и что на это сказать.</translation>
        </message>
        <message>
            <source>Time norm</source>
            <translation>Норма времени</translation>
        </message>
        <message>
            <source>Time of a student for the whole work.</source>
            <translation>На всю работу, для студента.</translation>
        </message>
        <message>
            <source>Control questions</source>
            <translation>Контрольные вопросы</translation>
        </message>
        <message>
            <source>For the defence of the work.</source>
            <translation>К защите работы.</translation>
        </message>
        <message>
            <source>Typical mistakes</source>
            <translation>Типичные ошибки</translation>
        </message>
        <message>
            <source>A view by its name for `--view`, or a panel or command.</source>
            <translation>Вид по имени для `--view`, панель или команда.</translation>
        </message>
        <message>
        <source>Name of the set</source>
        <translation>Название набора</translation>
    </message>
    <message>
        <source>Name of the catalogue entry.</source>
        <translation>Как называется запись каталога.</translation>
    </message>
    <message>
        <source>They are stored in the lesson itself: later changes of a catalogue change no variant.</source>
        <translation>Хранятся в самой работе: если каталог потом изменится, варианты останутся прежними.</translation>
    </message>
    <message>
        <source>Path of a number of the project, of a range or list.</source>
        <translation>Путь числа проекта, для диапазона или списка.</translation>
    </message>
    <message>
        <source>no range</source>
        <translation>диапазона нет</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Шаг</translation>
    </message>
    <message>
        <source>The values are the lower end and whole steps further, up to the upper end.</source>
        <translation>Значения — нижняя граница и далее целое число шагов, до верхней границы.</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Список</translation>
    </message>
    <message>
        <source>no list</source>
        <translation>списка нет</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Наборы</translation>
    </message>
    <message>
        <source>Values that belong together, as entries of a catalogue.</source>
        <translation>Значения, которые меняются вместе, как записи каталога.</translation>
    </message>
    <message>
        <source>Minimum best time</source>
        <translation>Лучшее время не менее</translation>
    </message>
    <message>
        <source>Maximum best time</source>
        <translation>Лучшее время не более</translation>
    </message>
    <message>
        <source>Relative to the best time of the original lesson.</source>
        <translation>От лучшего времени исходной работы.</translation>
    </message>
    <message>
        <source>Margin within</source>
        <translation>Отличие запаса не более</translation>
    </message>
    <message>
        <source>Largest difference between the minimum relative margin of the best answer and that of the original lesson, in percentage points.</source>
        <translation>Насколько наименьший относительный запас лучшего ответа может отличаться от запаса исходной работы, в процентных пунктах.</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>Сложность</translation>
    </message>
    <message>
        <source>Number of the step whose initial project has the figure, from 1.</source>
        <translation>Показатель — у проекта в начале этого шага; счёт от 1.</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Наименьшее</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Наибольшее</translation>
    </message>
    <message>
        <source>no minimum</source>
        <translation>не ограничено снизу</translation>
    </message>
    <message>
        <source>no maximum</source>
        <translation>не ограничено сверху</translation>
    </message>
    <message>
        <source>Every value of each input is combined with every value of the others.</source>
        <translation>Значения каждой сочетаются со всеми значениями остальных.</translation>
    </message>
    <message>
        <source>Permitted difference between the best answers.</source>
        <translation>Насколько могут различаться лучшие ответы.</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Показатели</translation>
    </message>
    <message>
        <source>Results that lie within bounds for every variant as given, so that the questions apply to it.</source>
        <translation>Что у каждого варианта в исходном виде лежит в заданных границах, чтобы вопросы работы были для него верны.</translation>
    </message>
    <message>
        <source>Number of the surface whose inputs are varied, from 1.</source>
        <translation>Поверхность, данные которой изменяются; счёт от 1.</translation>
    </message>
        <message>
            <source>Measuring uncertainty</source>
            <translation>Неопределённость измерения</translation>
        </message>
        <message>
            <source>Standard uncertainty of one measured value of a finished part. It counts as scatter of the prediction, and it widens the interval of the bias, for it may be the same for all parts.</source>
            <translation>Стандартная неопределённость одного измеренного значения готовой детали. Она входит в рассеяние прогноза и расширяет интервал смещения, так как может быть одной и той же у всех деталей.</translation>
        </message>
        <message>
            <source>Limit of bias</source>
            <translation>Предел смещения</translation>
        </message>
        <message>
            <source>a tenth of the tolerance</source>
            <translation>десятая часть допуска</translation>
        </message>
        <message>
            <source>Up to this difference the measured mean and the predicted one count as the same. Where the drawing has no tolerance either, it is half the predicted standard deviation.</source>
            <translation>До этой разности измеренное и прогнозируемое средние считаются одинаковыми. Если допуска нет и на чертеже, это половина прогнозируемого стандартного отклонения.</translation>
        </message>
        <message>
            <source>Measuring uncertainty of form</source>
            <translation>Неопределённость измерения формы</translation>
        </message>
        <message>
            <source>as for the size</source>
            <translation>как у размера</translation>
        </message>
        <message>
            <source>Standard uncertainty of one measured roundness, runout or cylindricity of a finished part.</source>
            <translation>Стандартная неопределённость одного измерения круглости, биения или цилиндричности готовой детали.</translation>
        </message>
        <message>
            <source>Limit of bias of form</source>
            <translation>Предел смещения формы</translation>
        </message>
        <message>
            <source>as for the size, otherwise a tenth of the tolerance</source>
            <translation>как у размера, иначе десятая доля допуска</translation>
        </message>
        <message>
            <source>Up to this difference the means of measured and predicted roundness, runout or cylindricity count as the same.</source>
            <translation>До этой разности средние измеренных и прогнозируемых отклонений от круглости, биения или цилиндричности считаются одинаковыми.</translation>
        </message>
        <message>
            <source>Force law</source>
            <translation>Закон силы</translation>
        </message>
        <message>
            <source>With a threshold nothing is cut below the force F′_0, and a spark-out ends exponentially; flow stress and dullness do not enter the force.</source>
            <translation>С порогом при силе ниже F′_0 съёма нет, а выхаживание заканчивается по экспоненте; интенсивность напряжений и степень затупления в силу не входят.</translation>
        </message>
        <message>
            <source>Threshold force</source>
            <translation>Пороговая сила</translation>
        </message>
        <message>
            <source>Normal force per millimetre of width up to which the wheel only rubs. It is found from a recorded spark-out, whose remainder is γ·b·F′_0.</source>
            <translation>Нормальная сила на миллиметр ширины, до которой круг только трёт. Определяется по записи выхаживания: остаётся γ·b·F′_0.</translation>
        </message>
        <message>
            <source>Specific normal force</source>
            <translation>Удельная нормальная сила</translation>
        </message>
        <message>
            <source>Normal force per area of chip, beyond the threshold. It is found from the time constant of a recorded spark-out.</source>
            <translation>Нормальная сила сверх пороговой на единицу площади среза. Определяется по постоянной времени записанного выхаживания.</translation>
        </message>
        <message>
            <source>Specific tangential force</source>
            <translation>Удельная касательная сила</translation>
        </message>
        <message>
            <source>K_0·ε_i/(ε_i·tg β), as in the sources&apos; law</source>
            <translation>K_0·ε_i/(ε_i·tg β), как в законе источников</translation>
        </message>
        <message>
            <source>Tangential force per area of chip, beyond the friction at the threshold; it determines the power.</source>
            <translation>Касательная сила на единицу площади среза сверх трения при пороговой силе: от неё зависит мощность.</translation>
        </message>
        <message>
            <source>Machine&apos;s form</source>
            <translation>Форма от станка</translation>
        </message>
        <message>
            <source>The form error that centres, headstock and spindle transfer to every part, by zone or section.</source>
            <translation>Что центры, передняя бабка и шпиндель передают каждой детали, по зонам или сечениям.</translation>
        </message>
        <message>
            <source>Roundness deviation of the machine</source>
            <translation>Отклонение от круглости от станка</translation>
        </message>
        <message>
            <source>Roundness deviation of a part ground to the end, of each zone or section, in their order.</source>
            <translation>Отклонение от круглости детали, шлифованной до конца, в каждой зоне или сечении по порядку.</translation>
        </message>
        <message>
            <source>Radial runout of the machine</source>
            <translation>Радиальное биение от станка</translation>
        </message>
        <message>
            <source>Radial runout of a part ground to the end, of each zone or section, in their order; no less than the roundness deviation. It is the mean over all directions of the eccentricity.</source>
            <translation>Радиальное биение детали, шлифованной до конца, в каждой зоне или сечении по порядку; не меньше отклонения от круглости. Среднее по всем направлениям эксцентриситета.</translation>
        </message>
        <message>
            <source>Number of lobes</source>
            <translation>Число граней от станка</translation>
        </message>
        <message>
            <source>2: an oval. An even number spreads the diameter by twice the roundness deviation, an odd one does not; roundness and runout do not show which. Not known: judged as odd, with the diameters for two lobes stated beside.</source>
            <translation>2 — овал. Чётное число разводит диаметры на два отклонения от круглости, нечётное — нет; отклонение от круглости и биение числа граней не определяют. Не известно: оценка как при нечётном, рядом диаметры при двух гранях.</translation>
        </message>
        <message>
            <source>Direction of the eccentricity</source>
            <translation>Направление эксцентриситета</translation>
        </message>
        <message>
            <source>the angle that gives the stated runout</source>
            <translation>где биение равно заданному</translation>
        </message>
        <message>
            <source>Angle on the part from where a lobe is ground deepest to where the eccentricity grinds deepest. In a batch it may scatter over the whole turn.</source>
            <translation>Угол на детали от места, где грань сошлифована глубже всего, до места, где глубже всего шлифует эксцентриситет. В партии может рассеиваться по всему обороту.</translation>
        </message>
        <message>
            <source>Factor on the roundness deviation and runout that the machine prints, of all zones or sections; without a form on its geometric runout.</source>
            <translation>Множитель отклонения от круглости и биения от станка, во всех зонах или сечениях; без формы — его геометрического биения.</translation>
        </message>
        <message>
            <source>Uniform from 0 to 360° where parts are clamped at random angles.</source>
            <translation>Равномерно от 0 до 360°, если детали устанавливают как придётся.</translation>
        </message>
        <message>
            <source>Company</source>
            <translation>Предприятие</translation>
        </message>
        <message>
            <source>Department</source>
            <translation>Подразделение</translation>
        </message>
        <message>
            <source>Prepared by</source>
            <translation>Разработал</translation>
        </message>
        <message>
            <source>Checked by</source>
            <translation>Проверил</translation>
        </message>
        <message>
            <source>Agreed by</source>
            <translation>Согласовал</translation>
        </message>
        <message>
            <source>Standards checked by</source>
            <translation>Нормоконтролёр</translation>
        </message>
        <message>
            <source>Approved by</source>
            <translation>Утвердил</translation>
        </message>
        <message>
            <source>Part designation</source>
            <translation>Обозначение изделия</translation>
        </message>
        <message>
            <source>Shop</source>
            <translation>Цех</translation>
        </message>
        <message>
            <source>Shop area</source>
            <translation>Участок</translation>
        </message>
        <message>
            <source>Work place</source>
            <translation>Рабочее место</translation>
        </message>
        <message>
            <source>Ministry</source>
            <translation>Министерство</translation>
        </message>
        <message>
            <source>University</source>
            <translation>Университет</translation>
        </message>
        <message>
            <source>Faculty or institute</source>
            <translation>Факультет или институт</translation>
        </message>
        <message>
            <source>University department</source>
            <translation>Кафедра</translation>
        </message>
        <message>
            <source>Discipline</source>
            <translation>Дисциплина</translation>
        </message>
        <message>
            <source>Accepted by (post and name)</source>
            <translation>Принял (должность, фамилия)</translation>
        </message>
        <message>
            <source>Town</source>
            <translation>Город</translation>
        </message>
        <message>
            <source>Wheel runout</source>
            <translation>Биение круга</translation>
        </message>
        <message>
            <source>How far the wheel runs out of true since its last dressing: an amplitude, an unbalance or a balance grade. It prints waves onto the part; not given, the waviness is not known.</source>
            <translation>Насколько круг бьёт после последней правки: амплитуда, дисбаланс или класс точности балансировки. От биения на детали остаются волны; если оно не задано, волнистость не известна.</translation>
        </message>
        <message>
            <source>Runout amplitude</source>
            <translation>Амплитуда биения</translation>
        </message>
        <message>
            <source>from the unbalance</source>
            <translation>по дисбалансу</translation>
        </message>
        <message>
            <source>Half of the total runout of the cutting surface at the working speed, as it has become since the last dressing: a wheel just dressed at that speed has none.</source>
            <translation>Половина полного биения режущей поверхности на рабочей скорости, появившегося после последней правки: у круга, только что правленного на этой скорости, его нет.</translation>
        </message>
        <message>
            <source>Waves of the wheel</source>
            <translation>Число волн круга</translation>
        </message>
        <message>
            <source>Number of waves around the wheel; 1: the surface is eccentric.</source>
            <translation>Число волн по окружности круга; 1 — поверхность эксцентрична.</translation>
        </message>
        <message>
            <source>Unbalance</source>
            <translation>Дисбаланс</translation>
        </message>
        <message>
            <source>from the grade, or none</source>
            <translation>по классу балансировки или нет</translation>
        </message>
        <message>
            <source>Mass out of balance times its radius, as it has become since the last dressing. It acts as a force on the wheel head, whose stiffness it needs.</source>
            <translation>Неуравновешенная масса, умноженная на её радиус, появившаяся после последней правки. Действует на шлифовальную бабку как сила; нужна жёсткость бабки.</translation>
        </message>
        <message>
            <source>Balance grade</source>
            <translation>Класс точности балансировки</translation>
        </message>
        <message>
            <source>Balance quality of the wheel with its spindle, 1 for the drives of grinders, 0.4 for the spindles of precision grinders.</source>
            <translation>Класс точности балансировки круга со шпинделем: 1 — приводы шлифовальных станков, 0,4 — шпиндели прецизионных.</translation>
        </message>
        <message>
            <source>Mass of the rotor</source>
            <translation>Масса ротора</translation>
        </message>
        <message>
            <source>Mass of the wheel with its flanges and spindle; the balance grade needs it.</source>
            <translation>Масса круга с фланцами и шпинделем; нужна для класса балансировки.</translation>
        </message>
        <message>
            <source>Phase of the wheel</source>
            <translation>Фаза круга</translation>
        </message>
        <message>
            <source>Angle of the runout at the beginning of the cycle; at 0 the wheel stands nearest to the part. In a batch it may scatter over the whole turn.</source>
            <translation>Угол биения в начале цикла; при 0 круг ближе всего к детали. В партии может рассеиваться по всему обороту.</translation>
        </message>
        <message>
            <source>Speed variation</source>
            <translation>Размах изменения частоты</translation>
        </message>
        <message>
            <source>How far the work speed rises and falls about its value, in percent of it.</source>
            <translation>Насколько частота вращения заготовки поднимается и опускается от заданной, в процентах от неё.</translation>
        </message>
        <message>
            <source>Period of the variation</source>
            <translation>Период изменения</translation>
        </message>
        <message>
            <source>Time from one highest speed to the next.</source>
            <translation>Время от одного наибольшего значения частоты до следующего.</translation>
        </message>
        <message>
            <source>Variation of the work speed</source>
            <translation>Изменение частоты вращения заготовки</translation>
        </message>
        <message>
            <source>constant speed</source>
            <translation>частота постоянна</translation>
        </message>
        <message>
            <source>The work speed rises and falls during the cycle, so that the waves of a wheel out of true do not print onto one another.</source>
            <translation>Частота вращения заготовки в течение цикла то больше, то меньше, чтобы волны от биения круга не ложились одна на другую.</translation>
        </message>
        <message>
            <source>Natural frequency of the wheel head</source>
            <translation>Собственная частота шлифовальной бабки</translation>
        </message>
        <message>
            <source>far above the wheel&apos;s revolutions</source>
            <translation>намного выше частоты вращения круга</translation>
        </message>
        <message>
            <source>Frequency at which the wheel head swings by itself. The nearer the wheel&apos;s revolutions are to it, the more an unbalance moves the wheel.</source>
            <translation>Частота, с которой шлифовальная бабка колеблется сама. Чем ближе к ней частота вращения круга, тем сильнее дисбаланс смещает круг.</translation>
        </message>
        <message>
            <source>Maximum height of the waves around the part, from peak to valley. It is decided where the runout of the wheel is given.</source>
            <translation>Наибольшая высота волн по окружности детали, от вершины до впадины. Оценивается, если задано биение круга.</translation>
        </message>
        <message>
            <source>Waviness</source>
            <translation>Волнистость</translation>
        </message>
        <message>
            <source>Uniform from 0 to 360°, as the wheel stands at any angle when a cycle begins.</source>
            <translation>Равномерно от 0 до 360°: в начале цикла круг стоит под любым углом.</translation>
        </message>
    </context>
    <context>
        <name>InputBrief</name>
        <message>
            <source>Radial feed</source>
            <translation>Радиальная подача</translation>
        </message>
        <message>
            <source>Cont. infeed</source>
            <translation>Непр. подача</translation>
        </message>
        <message>
            <source>Stock per side</source>
            <translation>Припуск на сторону</translation>
        </message>
        <message>
            <source>Spark-out</source>
            <translation>Выхаж.</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>Длина</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Диаметр</translation>
        </message>
        <message>
            <source>Position</source>
            <translation>Положение</translation>
        </message>
        <message>
            <source>Stiffness</source>
            <translation>Жёсткость</translation>
        </message>
        <message>
            <source>From</source>
            <translation>От</translation>
        </message>
        <message>
            <source>Width</source>
            <translation>Ширина</translation>
        </message>
    </context>
    <context>
        <name>Issue</name>
        <message>
            <source>%1 (stock on diameter)</source>
            <translation>%1 (припуск на диаметр)</translation>
        </message>
        <message>
            <source>the file is empty</source>
            <translation>файл пуст</translation>
        </message>
        <message>
            <source>{value} is too large; allowed: at most {limit}</source>
            <translation>{value} — слишком много; допускается не более {limit}</translation>
        </message>
        <message>
            <source>values are nested too deeply; allowed: {limit} levels</source>
            <translation>слишком глубокая вложенность; допускается уровней: {limit}</translation>
        </message>
        <message>
            <source>too many values; allowed: at most {limit}</source>
            <translation>слишком много значений; допускается не более {limit}</translation>
        </message>
        <message>
            <source>the text is {value} long; allowed: at most {limit}</source>
            <translation>длина текста {value}; допускается не более {limit}</translation>
        </message>
        <message>
            <source>{value} is not a Sparkout project; expected {limit}</source>
            <translation>{value} — не проект Sparkout; ожидается {limit}</translation>
        </message>
        <message>
            <source>version {value} was written by a newer Sparkout; this one reads versions {limit}</source>
            <translation>версия {value} записана более новой программой Sparkout; эта читает версии {limit}</translation>
        </message>
        <message>
            <source>this key appears here twice</source>
            <translation>этот ключ стоит здесь дважды</translation>
        </message>
        <message>
            <source>unknown key {value}; allowed: {limit}</source>
            <translation>неизвестный ключ {value}; допускаются: {limit}</translation>
        </message>
        <message>
            <source>value missing; allowed: {limit}</source>
            <translation>значение не задано; допускается: {limit}</translation>
        </message>
        <message>
            <source>{value} is of the wrong type; expected: {limit}</source>
            <translation>{value} — неверный тип; ожидается: {limit}</translation>
        </message>
        <message>
            <source>{value} is out of range; allowed: {limit}</source>
            <translation>{value} — вне допустимых значений; допускается: {limit}</translation>
        </message>
        <message>
            <source>{value} is not one of the choices; allowed: {limit}</source>
            <translation>{value} — нет такого варианта; допускаются: {limit}</translation>
        </message>
        <message>
            <source>{value} fits several: {limit}</source>
            <translation>{value} — подходит несколько: {limit}</translation>
        </message>
        <message>
            <source>{value} does not accept this part; machines of the catalogue that do: {limit}</source>
            <translation>{value} не принимает эту деталь; принимают станки каталога: {limit}</translation>
        </message>
        <message>
            <source>this wheel usually leaves Ra {value}, more than required; the catalogue&apos;s wheel that suits: {limit}</source>
            <translation>этот круг обычно даёт Ra {value}, грубее требуемой; подходит круг каталога: {limit}</translation>
        </message>
        <message>
            <source>no law given; expected one of {limit}</source>
            <translation>закон не задан; ожидается один из: {limit}</translation>
        </message>
        <message>
            <source>this is not a Sparkout project: the text is not valid JSON in UTF-8: line {value}, column {limit}</source>
            <translation>это не проект Sparkout: текст не является правильным JSON в UTF-8: строка {value}, столбец {limit}</translation>
        </message>
        <message>
            <source>{value} is unusual; usual: {limit}</source>
            <translation>{value} — необычное значение; обычно: {limit}</translation>
        </message>
        <message>
            <source>there are {value} values; expected: {limit}</source>
            <translation>значений: {value}; ожидается: {limit}</translation>
        </message>
        <message>
            <source>{value} is odd; allowed: an even number, {limit}</source>
            <translation>{value} — нечётное число; допускается чётное, {limit}</translation>
        </message>
        <message>
            <source>{value} radii do not separate lobing from eccentricity; better: {limit}</source>
            <translation>число радиусов {value} не позволяет отличить огранку от эксцентриситета; лучше: {limit}</translation>
        </message>
        <message>
            <source>the lower deviation {value} is not below the upper one; allowed: below {limit}</source>
            <translation>нижнее отклонение {value} не меньше верхнего; допускается меньше {limit}</translation>
        </message>
        <message>
            <source>{value} leaves no zone between the reversal zones; allowed: {limit}. A narrower wheel, longer overruns or plunge grinding would help</source>
            <translation>{value} не оставляет нереверсной зоны между реверсными; допускается: {limit}. Помогут более узкий круг, большие перебеги или врезное шлифование</translation>
        </message>
        <message>
            <source>{value} does not cover the ground length of a plunge cycle; allowed: {limit}</source>
            <translation>{value} не перекрывает длину шлифования врезного цикла; допускается: {limit}</translation>
        </message>
        <message>
            <source>{value} does not fit into the hole; allowed: {limit}</source>
            <translation>{value} не входит в отверстие; допускается: {limit}</translation>
        </message>
        <message>
            <source>{value} does not fit the machine; allowed: {limit}</source>
            <translation>{value} не подходит станку; допускается: {limit}</translation>
        </message>
        <message>
            <source>no compliance is given and none can be computed; needed: {limit}</source>
            <translation>податливость не задана и вычислить её не по чему; нужно: {limit}</translation>
        </message>
        <message>
            <source>only the last stage may be a spark-out; this is stage {value} of {limit}</source>
            <translation>выхаживанием может быть только последняя ступень; эта — {value} из {limit}</translation>
        </message>
        <message>
            <source>a spark-out stage has no feed: {value} is not used</source>
            <translation>на ступени выхаживания подачи нет: {value} не используется</translation>
        </message>
        <message>
            <source>{value} would never reach size; allowed: {limit}</source>
            <translation>при {value} размер не будет достигнут никогда; допускается: {limit}</translation>
        </message>
        <message>
            <source>{value} stages need more gauge commands than available; allowed: {limit}</source>
            <translation>ступеней {value}, это больше числа команд прибора; допускается: {limit}</translation>
        </message>
        <message>
            <source>{value} is not used here; it applies to {limit}</source>
            <translation>{value} здесь не используется; относится к {limit}</translation>
        </message>
        <message>
            <source>{value} runs the wheel into the wall of the blind bore; allowed: {limit}</source>
            <translation>{value}: круг упрётся в стенку глухого отверстия; допускается: {limit}</translation>
        </message>
        <message>
            <source>the wheel turns {value} before the wall of the blind bore: the unreached length must be relieved</source>
            <translation>круг разворачивается за {value} до стенки глухого отверстия: там, куда он не доходит, нужна канавка</translation>
        </message>
        <message>
            <source>the shaft is {value} long; needed: {limit}</source>
            <translation>длина вала {value}; нужно: {limit}</translation>
        </message>
        <message>
            <source>the target {value} lies outside the tolerance band {limit}</source>
            <translation>целевой размер {value} лежит вне поля допуска {limit}</translation>
        </message>
        <message>
            <source>the part stays {value} above size: a spark-out has no feed, and the deflection did not remove its stock of {limit}</source>
            <translation>до размера остаётся {value}: при выхаживании подачи нет, и отжатие не вернуло припуск ступени {limit}</translation>
        </message>
        <message>
            <source>given compliances do not determine how a force in one section deflects the others; needed: {limit}</source>
            <translation>по заданным податливостям не видно, как сила в одном сечении отжимает другие; нужно: {limit}</translation>
        </message>
        <message>
            <source>{value} has neither a source nor a mark as an estimate; needed: its line in {limit}</source>
            <translation>для {value} не указан ни источник, ни что это оценка; нужна строка в {limit}</translation>
        </message>
        <message>
            <source>the text is not valid JSON in UTF-8: line {value}, column {limit}</source>
            <translation>текст не является правильным JSON в UTF-8: строка {value}, столбец {limit}</translation>
        </message>
        <message>
            <source>the stages&apos; stocks sum to {value}, the part&apos;s stock is {limit}; the first stage takes what the later ones leave</source>
            <translation>сумма припусков ступеней {value}, припуск детали {limit}; первой ступени достаётся то, что оставляют следующие</translation>
        </message>
        <message>
            <source>{value} is not a number of the project; needed: {limit}</source>
            <translation>{value} — не число проекта; нужно: {limit}</translation>
        </message>
        <message>
            <source>{value} is varied twice; needed: {limit}</source>
            <translation>{value} варьируется дважды; нужно: {limit}</translation>
        </message>
        <message>
            <source>stage {value} of {limit} makes no step: those before it have already removed its stock</source>
            <translation>ступень {value} из {limit} не делает ни одного шага: её припуск уже снят ступенями до неё</translation>
        </message>
        <message>
            <source>a dwell of {value} is rounded to {limit}, whole revolutions</source>
            <translation>выстой {value} округлён до {limit}, до целых оборотов</translation>
        </message>
        <message>
            <source>a file of version {value} holds several surfaces of a part; the window and sparkout-cli open it</source>
            <translation>файл версии {value} содержит несколько поверхностей детали; его принимают окно программы и sparkout-cli</translation>
        </message>
        <message>
            <source>{value} is already the name of surface {limit}</source>
            <translation>{value} — уже имя поверхности {limit}</translation>
        </message>
        <message>
            <source>{value} applies to all surfaces and belongs outside them</source>
            <translation>{value} — общее для всех поверхностей и стоит вне их</translation>
        </message>
        <message>
            <source>the gaps leave too little of the surface: {value} radii lie outside them; needed: {limit}, two of them opposite each other</source>
            <translation>пазы оставляют слишком мало поверхности: вне их радиусов {value}; нужно: {limit}, из них два напротив друг друга</translation>
        </message>
        <message>
            <source>a gap of {value} lies between two radii, which are {limit} apart: it has no effect</source>
            <translation>паз {value} лежит между двумя радиусами, шаг которых {limit}: он ничего не исключает</translation>
        </message>
        <message>
            <source>this gauge drops into the gaps; needed: {limit}</source>
            <translation>прибор проваливается в пазы; нужно: {limit}</translation>
        </message>
        <message>
            <source>{value} is not an input of this project; needed: {limit}</source>
            <translation>{value} — не исходная величина этого проекта; нужно: {limit}</translation>
        </message>
        <message>
            <source>{value} is named twice</source>
            <translation>имя {value} встречается дважды</translation>
        </message>
        <message>
            <source>{value} cannot be the name of a file; needed: {limit}</source>
            <translation>{value} не может быть именем файла; требуется: {limit}</translation>
        </message>
        <message>
            <source>{value} is unusual beside the other inputs; usual: {limit}</source>
            <translation>{value} — необычное значение при остальных исходных данных; обычно: {limit}</translation>
        </message>
        <message>
        <source>an overrun of {value} runs the wheel into a shoulder of the shaft; allowed: {limit}</source>
        <translation>при перебеге {value} круг набегает на уступ вала; допускается: {limit}</translation>
    </message>
    <message>
        <source>a wheel {value} wide does not fit between the shoulders of the shaft; allowed: {limit}</source>
        <translation>круг высотой {value} не проходит между уступами вала; допускается: {limit}</translation>
    </message>
        <message>
            <source>{value} belongs to the sources&apos; force law and is not computed for one with a threshold; allowed: {limit}</source>
            <translation>{value}: относится к закону силы источников, для закона с порогом не вычисляется; допустимо: {limit}</translation>
        </message>
        <message>
            <source>the number of lobes is not known: an even one spreads the diameters by {value} in a field of {limit}; judged as an odd one</source>
            <translation>число граней неизвестно: чётное разводит диаметры на {value} при поле {limit}; оценка — как при нечётном</translation>
        </message>
        <message>
            <source>{value} radii do not resolve the waves that the wheel prints; needed: {limit}</source>
            <translation>при числе радиусов {value} волны от круга не видны; нужно: {limit}</translation>
        </message>
</context>
    <context>
        <name>LayersLook</name>
        <message>
            <source>stage %1</source>
            <translation>ступень %1</translation>
        </message>
        <message>
            <source>Double stroke %1, stage %2</source>
            <translation>Двойной ход %1, ступень %2</translation>
        </message>
        <message>
            <source>Revolution %1, stage %2</source>
            <translation>Оборот %1, ступень %2</translation>
        </message>
        <message>
            <source>Double strokes %1…%2, stage %3</source>
            <translation>Двойные ходы %1…%2, ступень %3</translation>
        </message>
        <message>
            <source>Revolutions %1…%2, stage %3</source>
            <translation>Обороты %1…%2, ступень %3</translation>
        </message>
        <message>
            <source>%1, %2: removes %3 µm, %4 µm so far, radius %5 µm from target</source>
            <translation>%1, %2: снимается %3 мкм, всего снято %4 мкм, радиус %5 мкм от целевого</translation>
        </message>
    </context>
    <context>
        <name>LengthCurves</name>
        <message>
            <source>Diameter from the middle of the field, µm</source>
            <translation>Диаметр от середины поля, мкм</translation>
        </message>
        <message>
            <source>limits of the field, ±%1 µm</source>
            <translation>границы поля, ±%1 мкм</translation>
        </message>
        <message>
            <source>%1: minimum, µm</source>
            <translation>%1: наименьшее, мкм</translation>
        </message>
        <message>
            <source>%1: maximum, µm</source>
            <translation>%1: наибольшее, мкм</translation>
        </message>
        <message>
            <source>%1, µm</source>
            <translation>%1, мкм</translation>
        </message>
        <message>
            <source>From the headstock end of the ground length, mm</source>
            <translation>От начала шлифуемой длины со стороны передней бабки, мм</translation>
        </message>
    </context>
    <context>
        <name>Limit</name>
        <message>
            <source>number</source>
            <translation>число</translation>
        </message>
        <message>
            <source>text</source>
            <translation>текст</translation>
        </message>
        <message>
            <source>list of objects</source>
            <translation>список объектов</translation>
        </message>
        <message>
            <source>object</source>
            <translation>объект</translation>
        </message>
        <message>
            <source>whole number</source>
            <translation>целое число</translation>
        </message>
        <message>
            <source>list of numbers</source>
            <translation>список чисел</translation>
        </message>
        <message>
            <source>whole number or &quot;until_size&quot;</source>
            <translation>целое число или &quot;until_size&quot;</translation>
        </message>
        <message>
            <source>object with rz1, nz, rz2, or list of numbers, or null</source>
            <translation>объект с rz1, nz, rz2, или список чисел, или null</translation>
        </message>
        <message>
            <source>number, mm/N</source>
            <translation>число, мм/Н</translation>
        </message>
        <message>
            <source>list of numbers, or object with from, to, step</source>
            <translation>список чисел или объект с from, to, step</translation>
        </message>
        <message>
            <source>list of rows of numbers, or null</source>
            <translation>список строк чисел или null</translation>
        </message>
        <message>
            <source>true or false</source>
            <translation>true или false</translation>
        </message>
        <message>
            <source>a compliance computed from stiffness and shaft</source>
            <translation>податливость, вычисленная по жёсткости и валу</translation>
        </message>
        <message>
            <source>a value for each zone: { rz1, nz, rz2 }</source>
            <translation>значение для каждой зоны: { rz1, nz, rz2 }</translation>
        </message>
        <message>
            <source>a compliance as given, or stiffness and shaft to compute it from</source>
            <translation>заданная податливость либо жёсткость и вал для её расчёта</translation>
        </message>
        <message>
            <source>length and diameter of the quill</source>
            <translation>вылет и диаметр оправки</translation>
        </message>
        <message>
            <source>length and diameter of each step of the shaft</source>
            <translation>длина и диаметр каждой ступени вала</translation>
        </message>
        <message>
            <source>a positive definite matrix</source>
            <translation>положительно определённая матрица</translation>
        </message>
        <message>
            <source>an object</source>
            <translation>объект</translation>
        </message>
        <message>
            <source>another input</source>
            <translation>другая величина</translation>
        </message>
        <message>
            <source>the path of an input, as /wheel/dullness</source>
            <translation>путь исходной величины, например /wheel/dullness</translation>
        </message>
        <message>
            <source>plunge</source>
            <translation>врезному шлифованию</translation>
        </message>
        <message>
            <source>&quot;rz1&quot;, &quot;nz&quot;, &quot;rz2&quot;, or the number of a section</source>
            <translation>«rz1», «nz», «rz2» или номер сечения</translation>
        </message>
        <message>
            <source>a list of texts that are base64 together</source>
            <translation>список строк, составляющих вместе текст base64</translation>
        </message>
        <message>
            <source>the name of a file without a folder, ending in .sparkout-lesson</source>
            <translation>имя файла без папки, оканчивающееся на .sparkout-lesson</translation>
        </message>
        <message>
            <source>one that reads the largest diameter</source>
            <translation>правило наибольшего диаметра</translation>
        </message>
    </context>
    <context>
        <name>LimitNames</name>
        <message>
            <source>%1, wheel standing</source>
            <translation>%1, круг стоит</translation>
        </message>
        <message>
            <source>%1, strokes</source>
            <translation>%1, ходы</translation>
        </message>
        <message>
            <source>%1 %</source>
            <translation>%1 %</translation>
        </message>
        <message>
            <source>&gt;%1 %</source>
            <translation>&gt;%1 %</translation>
        </message>
        <message>
            <source>Not checked, input missing: %1</source>
            <translation>Не проверяется, нет исходных данных: %1</translation>
        </message>
        <message>
            <source>Roughness is not limiting while it is not calibrated: %1</source>
            <translation>Шероховатость не ограничивает подачу, пока расчёт не откалиброван: %1</translation>
        </message>
        <message>
            <source>Roughness is not limiting while it is not calibrated: the computed Ra is a range, and no depth of cut can be derived from it.</source>
            <translation>Шероховатость не ограничивает подачу, пока расчёт не откалиброван: расчётный параметр Ra — диапазон, и допустимую глубину резания по нему определить нельзя.</translation>
        </message>
        <message>
            <source>Machine not known, the process alone: %1</source>
            <translation>Без погрешности станка, она не задана: %1</translation>
        </message>
    </context>
    <context>
        <name>Location</name>
        <message>
            <source>%1 %2</source>
            <translation>%1 %2</translation>
        </message>
        <message>
            <source>Surface %1</source>
            <translation>Поверхность %1</translation>
        </message>
    </context>
    <context>
        <name>Marking</name>
        <message>
            <source>black silicon carbide</source>
            <translation>чёрный карбид кремния</translation>
        </message>
        <message>
            <source>green silicon carbide</source>
            <translation>зелёный карбид кремния</translation>
        </message>
        <message>
            <source>silicon carbide</source>
            <translation>карбид кремния</translation>
        </message>
        <message>
            <source>normal fused alumina</source>
            <translation>нормальный электрокорунд</translation>
        </message>
        <message>
            <source>white fused alumina</source>
            <translation>белый электрокорунд</translation>
        </message>
        <message>
            <source>fused alumina</source>
            <translation>электрокорунд</translation>
        </message>
        <message>
            <source>vitrified bond</source>
            <translation>керамическая связка</translation>
        </message>
        <message>
            <source>resin bond</source>
            <translation>бакелитовая связка</translation>
        </message>
        <message>
            <source>rubber bond</source>
            <translation>вулканитовая связка</translation>
        </message>
        <message>
            <source>shellac bond</source>
            <translation>шеллаковая связка</translation>
        </message>
        <message>
            <source>magnesite bond</source>
            <translation>магнезитовая связка</translation>
        </message>
        <message>
            <source>plastic bond</source>
            <translation>пластмассовая связка</translation>
        </message>
        <message>
            <source>∅%1 mm, width %2 mm, bore %3 mm</source>
            <translation>∅%1 мм, высота %2 мм, отверстие %3 мм</translation>
        </message>
        <message>
            <source>∅%1 mm, width %2 mm</source>
            <translation>∅%1 мм, высота %2 мм</translation>
        </message>
        <message>
            <source>F%1 – grain %2 mm</source>
            <translation>F%1 – зерно %2 мм</translation>
        </message>
        <message>
            <source>%1 – hardness (A softest, Z hardest)</source>
            <translation>%1 – твёрдость (A самый мягкий, Z самый твёрдый)</translation>
        </message>
        <message>
            <source>structure %1 – grain share %2</source>
            <translation>структура %1 – доля зерна %2</translation>
        </message>
        <message>
            <source>at most %1 m/s</source>
            <translation>не более %1 м/с</translation>
        </message>
    </context>
    <context>
        <name>Names</name>
        <message>
            <source>RZ1</source>
            <comment>entry reversal zone, short</comment>
            <translation>РЗ1</translation>
        </message>
        <message>
            <source>NZ</source>
            <comment>zone between reversals, short</comment>
            <translation>НЗ</translation>
        </message>
        <message>
            <source>RZ2</source>
            <comment>exit reversal zone, short</comment>
            <translation>РЗ2</translation>
        </message>
        <message>
            <source>Section %1</source>
            <translation>Сечение %1</translation>
        </message>
        <message>
            <source>Entry reversal zone RZ1</source>
            <translation>Реверсная зона входа РЗ1</translation>
        </message>
        <message>
            <source>Zone between reversals NZ</source>
            <translation>Нереверсная зона НЗ</translation>
        </message>
        <message>
            <source>Exit reversal zone RZ2</source>
            <translation>Реверсная зона выхода РЗ2</translation>
        </message>
        <message>
            <source>E%1</source>
            <comment>step of a double stroke</comment>
            <translation>Э%1</translation>
        </message>
        <message>
            <source>plunge-in</source>
            <translation>врезание</translation>
        </message>
        <message>
            <source>entry dwell</source>
            <translation>выстой на входе</translation>
        </message>
        <message>
            <source>working stroke</source>
            <translation>рабочий ход</translation>
        </message>
        <message>
            <source>exit dwell</source>
            <translation>выстой на выходе</translation>
        </message>
        <message>
            <source>plunge-in at the exit</source>
            <translation>врезание на выходе</translation>
        </message>
        <message>
            <source>return stroke</source>
            <translation>обратный ход</translation>
        </message>
        <message>
            <source>stage %1</source>
            <translation>ступень %1</translation>
        </message>
        <message>
            <source>double stroke %1</source>
            <translation>двойной ход %1</translation>
        </message>
        <message>
            <source>revolution %1</source>
            <translation>оборот %1</translation>
        </message>
        <message>
            <source>Completed</source>
            <translation>Цикл завершён</translation>
        </message>
        <message>
            <source>Cannot reach size</source>
            <translation>Размер недостижим</translation>
        </message>
        <message>
            <source>Too long: the run was ended</source>
            <translation>Слишком долго: расчёт прерван</translation>
        </message>
        <message>
            <source>Stopped</source>
            <translation>Остановлен</translation>
        </message>
        <message>
            <source>and %1 more</source>
            <translation>и ещё %1</translation>
        </message>
        <message>
            <source>The balance of forces was not solved</source>
            <translation>Равновесие сил не найдено</translation>
        </message>
        <message>
            <source>The inputs are refused</source>
            <translation>Исходные данные не приняты</translation>
        </message>
        <message>
            <source>whole part</source>
            <translation>вся деталь</translation>
        </message>
        <message>
            <source>cycle</source>
            <translation>цикл</translation>
        </message>
        <message>
            <source>dwell after return</source>
            <translation>2-й выстой</translation>
        </message>
        <message>
            <source>Before the first touch</source>
            <translation>До первого касания</translation>
        </message>
        <message>
            <source>After double stroke %1 of %2</source>
            <translation>После двойного хода %1 из %2</translation>
        </message>
        <message>
            <source>After revolution %1 of %2</source>
            <translation>После оборота %1 из %2</translation>
        </message>
        <message>
            <source>Within double stroke %1 of %2</source>
            <translation>Внутри двойного хода %1 из %2</translation>
        </message>
        <message>
            <source>Within revolution %1 of %2</source>
            <translation>Внутри оборота %1 из %2</translation>
        </message>
        <message>
            <source>in range</source>
            <translation>в диапазоне</translation>
        </message>
        <message>
            <source>out of range</source>
            <translation>вне диапазона</translation>
        </message>
        <message>
            <source>double stroke %1</source>
            <comment>short</comment>
            <translation>дв. ход %1</translation>
        </message>
        <message>
            <source>Strips stay uncut (overlap B/s %1, below 1): this is not the whole surface, and its size, form and roughness are those of the cut part alone.</source>
            <translation>Остаются непрошлифованные полосы (коэффициент перекрытия B/s %1, меньше 1): это не вся поверхность, её размер, форма и шероховатость относятся только к прошлифованной части.</translation>
        </message>
        <message>
            <source>The part is ground away</source>
            <translation>Деталь сошлифована полностью</translation>
        </message>
        <message>
            <source>%1, machine not known</source>
            <comment>the form it prints</comment>
            <translation>%1, без погрешности станка</translation>
        </message>
        <message>
            <source>%1, waves not known</source>
            <comment>that the wheel prints</comment>
            <translation>%1, волны не известны</translation>
        </message>
        <message>
            <source>%1 s</source>
            <comment>time of a cycle</comment>
            <translation>%1 с</translation>
        </message>
        <message>
            <source>%1 min</source>
            <comment>time of a cycle</comment>
            <translation>%1 мин</translation>
        </message>
    </context>
    <context>
        <name>OperationNotice</name>
        <message>
            <source>A plunge grinds only the length that the wheel covers. These inputs changed with the operation: %1.</source>
            <translation>Врезанием шлифуется не больше, чем перекрывает круг. Вместе с операцией изменены: %1.</translation>
        </message>
        <message>
            <source>These inputs changed with the operation: %1.</source>
            <translation>Вместе с операцией изменены: %1.</translation>
        </message>
        <message>
            <source>zone by zone</source>
            <translation>по зонам</translation>
        </message>
        <message>
            <source>section by section</source>
            <translation>по сечениям</translation>
        </message>
    </context>
    <context>
        <name>LawsNotice</name>
        <message>
            <source>Distributions of the batch follow this edit: %1.</source>
            <translation>Распределения партии изменены вслед за правкой: %1.</translation>
        </message>
    </context>
    <context>
        <name>Search</name>
        <message>
            <source>more than 9·10¹⁸ cycles</source>
            <translation>более 9·10¹⁸ циклов</translation>
        </message>
        <message>
            <source>%1 cycles</source>
            <translation>циклов: %1</translation>
        </message>
        <message>
            <source>any number</source>
            <translation>любое число</translation>
        </message>
        <message>
            <source>at least %1</source>
            <translation>не менее %1</translation>
        </message>
        <message>
            <source>Farther from the limits</source>
            <translation>Дальше от пределов</translation>
        </message>
        <message>
            <source>Between the levels</source>
            <translation>Между уровнями</translation>
        </message>
        <message>
            <source>Stages: %1</source>
            <translation>Ступеней: %1</translation>
        </message>
        <message>
            <source>rounds of levels: %1</source>
            <translation>проходов с новыми уровнями: %1</translation>
        </message>
        <message>
            <source>best %1</source>
            <translation>лучший %1</translation>
        </message>
        <message>
            <source>none below %1</source>
            <translation>нет быстрее %1</translation>
        </message>
        <message>
            <source>%1 % searched</source>
            <translation>пройдено %1 %</translation>
        </message>
        <message>
            <source>%1 judged</source>
            <translation>проверено %1</translation>
        </message>
        <message>
            <source>Begins</source>
            <translation>Начало</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 с</translation>
        </message>
        <message>
            <source>This method is for plunge grinding; the exact search handles traverse cycles (%1).</source>
            <translation>Этот метод — для врезного шлифования; циклы с продольной подачей ищет точный поиск (%1).</translation>
        </message>
        <message>
            <source>This method searches only for the minimum time.</source>
            <translation>Этот метод ищет только наименьшее время.</translation>
        </message>
        <message>
            <source>The refinement between the levels looks only for the minimum time.</source>
            <translation>Уточнение между уровнями ищет только наименьшее время.</translation>
        </message>
        <message>
            <source>The minimum cost needs the cost of a part.</source>
            <translation>Для наименьшей стоимости нужна стоимость детали.</translation>
        </message>
        <message>
            <source>The maximum margin within a time is searched only with the objective “minimum time”.</source>
            <translation>Наибольший запас за время ищется только с целью «наименьшее время».</translation>
        </message>
        <message>
            <source>Cost and wheel life are searched only for the given part, not for other stocks within one infeed or for the batch.</source>
            <translation>Стоимость и стойкость круга ищутся для детали, как она задана: только для её припуска и без партии.</translation>
        </message>
        <message>
            <source>The inputs of the search are missing.</source>
            <translation>Не задано, что искать.</translation>
        </message>
        <message>
            <source>Both feeds need levels.</source>
            <translation>Обеим подачам нужны уровни.</translation>
        </message>
        <message>
            <source>The plunge feed needs levels.</source>
            <translation>Врезной подаче нужны уровни.</translation>
        </message>
        <message>
            <source>A stage would have more than %1 settings of its feeds: use fewer levels.</source>
            <translation>У ступени было бы более %1 сочетаний подач: задайте меньше уровней.</translation>
        </message>
        <message>
            <source>The stock would have more than %1 steps: use a larger step.</source>
            <translation>У припуска было бы более %1 шагов: увеличьте шаг.</translation>
        </message>
        <message>
            <source>Work speed, dwells and spark-outs make more than %1 combinations: use fewer levels.</source>
            <translation>Частота вращения, выстои и выхаживания дают более %1 сочетаний: возьмите меньше уровней.</translation>
        </message>
        <message>
            <source>The rotation ratio is %1, nearer to a whole number than “%2” allows (%3): change it, or search “%4”.</source>
            <translation>Отношение частот вращения круга и детали — %1, ближе к целому числу, чем допускает «%2» (%3): измените это значение или ищите и по «%4».</translation>
        </message>
        <message>
            <source>With every work speed of the search the rotation ratio is nearer to a whole number than “%1” allows (%2): change it, or “%3”.</source>
            <translation>При всех частотах вращения заготовки в поиске отношение частот круга и детали ближе к целому числу, чем допускает «%1» (%2): измените это значение или «%3».</translation>
        </message>
        <message>
            <source>The stock cannot be divided into these numbers of stages: use a smaller step, or other limits of the stages&apos; feeds and stocks.</source>
            <translation>Припуск нельзя разделить на столько ступеней: возьмите меньший шаг или другие пределы подач и припусков ступеней.</translation>
        </message>
        <message>
            <source>Stopped before a cycle that meets every requirement was found.</source>
            <translation>Остановлено раньше, чем нашёлся цикл, который выдерживает все требования.</translation>
        </message>
        <message>
            <source>No cycle was found that is fit in every scenario, and none is quicker than %1; each cycle tried was unfit in a further scenario.</source>
            <translation>Не найдено цикла, годного во всех сценариях, и ни один не короче %1; каждый испытанный не выдержал ещё одного сценария.</translation>
        </message>
        <message>
            <source>The heuristic found no cycle that meets every requirement; there may be one, which the exact search finds (%1).</source>
            <translation>Эвристика не нашла цикла, который выполняет все требования; он может быть, его найдёт точный поиск (%1).</translation>
        </message>
        <message>
            <source>No cycle of the grid that takes at most %1 min meets every requirement.</source>
            <translation>Ни один цикл сетки, который не длиннее %1 мин, не выдерживает всех требований.</translation>
        </message>
        <message>
            <source>No cycle of the grid meets every requirement.</source>
            <translation>Ни один цикл сетки не выдерживает всех требований.</translation>
        </message>
        <message>
            <source>%1 (%2 times)</source>
            <translation>%1 (%2 раз)</translation>
        </message>
        <message>
            <source>Of cycles whose parts are all good, the Ppk or the expected share outside misses the batch's limit: %1.</source>
            <translation>Циклов, у которых все детали годны, но Ppk или ожидаемая доля брака не укладывается в предел партии: %1.</translation>
        </message>
        <message>
            <source>Excluded most often by: %1.</source>
            <translation>Чаще всего мешают: %1.</translation>
        </message>
        <message>
            <source>The requirement with the minimum margin is not known: the search was stopped first.</source>
            <translation>Требование с наименьшим запасом неизвестно: поиск был остановлен раньше.</translation>
        </message>
        <message>
            <source>The limit of the time is not known: the search was stopped first.</source>
            <translation>Что ограничивает время, неизвестно: поиск был остановлен раньше.</translation>
        </message>
        <message>
            <source>The minimum margin is that of: %1.</source>
            <translation>Наименьший запас у требования: %1.</translation>
        </message>
        <message>
            <source>Limited by: %1.</source>
            <translation>Время ограничивает: %1.</translation>
        </message>
        <message>
            <source>No cycle of the grid that differs in one setting is quicker.</source>
            <translation>Ни один цикл сетки, отличающийся одной настройкой, не быстрее.</translation>
        </message>
        <message>
            <source>Levels were added around the answer; rounds: %1.</source>
            <translation>Вокруг ответа добавлены уровни; проходов поиска: %1.</translation>
        </message>
        <message>
            <source>Stopped while further levels were searched: the answer is that of the grid before.</source>
            <translation>Остановлено при поиске с новыми уровнями: ответ дан по предыдущей сетке.</translation>
        </message>
        <message>
            <source>“%1” has the maximum level, %2;</source>
            <translation>«%1» на наибольшем уровне, %2;</translation>
        </message>
        <message>
            <source>“%1” has the minimum level, %2;</source>
            <translation>«%1» на наименьшем уровне, %2;</translation>
        </message>
        <message>
            <source>no other is allowed.</source>
            <translation>дальше нельзя.</translation>
        </message>
        <message>
            <source>No margin is left for: %1. For a cycle with a margin, set “%2” in the search.</source>
            <translation>Нет запаса: %1. Чтобы найти цикл с запасом, задайте в поиске «%2».</translation>
        </message>
        <message>
            <source>The rotation ratio of wheel and work is near a whole number, %1: waviness. To rule that out, set “%2” in the search.</source>
            <translation>Отношение частот вращения круга и детали близко к целому числу, %1: волнистость. Чтобы её исключить, задайте в поиске «%2».</translation>
        </message>
        <message>
            <source>Work speeds left out because their rotation ratio is nearer to a whole number than “%1” allows: %2.</source>
            <translation>Не рассматривались частоты вращения заготовки, при которых отношение частот ближе к целому числу, чем допускает «%1»: %2.</translation>
        </message>
        <message>
            <source>Stage %1: “%2” has the maximum level, %3;</source>
            <translation>Ступень %1: «%2» на наибольшем уровне, %3;</translation>
        </message>
        <message>
            <source>Stage %1: “%2” has the minimum level, %3;</source>
            <translation>Ступень %1: «%2» на наименьшем уровне, %3;</translation>
        </message>
        <message>
            <source>the limits of the search, “%1”, end there;</source>
            <translation>здесь кончаются пределы, заданные в поиске («%1»);</translation>
        </message>
        <message>
            <source>no level of the search is beyond;</source>
            <translation>дальше уровней поиска нет;</translation>
        </message>
        <message>
            <source>the limits of the search, “%1”, end at %2.</source>
            <translation>пределы, заданные в поиске («%1»), кончаются на %2.</translation>
        </message>
        <message>
            <source>the machine&apos;s range ends there.</source>
            <translation>здесь кончается диапазон станка.</translation>
        </message>
        <message>
            <source>the machine allows up to %1.</source>
            <translation>станок допускает до %1.</translation>
        </message>
        <message>
            <source>the machine allows down to %1.</source>
            <translation>станок допускает от %1.</translation>
        </message>
        <message>
            <source>the machine&apos;s range is not given.</source>
            <translation>диапазон станка не задан.</translation>
        </message>
        <message>
            <source>allowed: %1.</source>
            <translation>допускается %1.</translation>
        </message>
        <message>
            <source>smaller values are allowed.</source>
            <translation>допускаются и меньшие.</translation>
        </message>
        <message>
            <source>Margins by time are searched for the minimum time, or for the maximum margin; this search is for parts between dressings.</source>
            <translation>Запас по времени ищется с целью «наименьшее время» или для наибольшего запаса; этот поиск — по деталям между правками.</translation>
        </message>
        <message>
            <source>Margins by time are searched only by the exact search (%1).</source>
            <translation>Запасы по времени ищет только точный поиск (%1).</translation>
        </message>
        <message>
            <source>The search for margins by time continues.</source>
            <translation>Запасы по времени ещё ищутся.</translation>
        </message>
        <message>
            <source>Margins by time for all stocks within one infeed are searched only under gauge control.</source>
            <translation>Запас по времени для всех припусков в пределах подачи на шаг ищется только при управлении от прибора.</translation>
        </message>
        <message>
            <source>No margins by time: the search was stopped first, or no cycle is fit.</source>
            <translation>Запаса по времени нет: поиск остановлен раньше или ни один цикл не годен.</translation>
        </message>
        <message>
            <source>Cycles of the grid that no other cycle beats in both time and distance from its limits: %1.</source>
            <translation>Все циклы сетки, быстрее и дальше от пределов которых одновременно нет ни одного: %1.</translation>
        </message>
        <message>
            <source>Up to %1; cycles that take longer may have larger margins.</source>
            <translation>Найдено до %1; у более длинных циклов запас может быть больше.</translation>
        </message>
        <message>
            <source>The margin is the least over all cases for which the cycle must be fit.</source>
            <translation>Запас — наименьший по всем случаям, для которых цикл должен быть годен.</translation>
        </message>
        <message>
            <source>%1 min</source>
            <translation>%1 мин</translation>
        </message>
        <message>
            <source>Work speeds left out because their rotation ratio is within %1 of a whole number, where the waves of the wheel, whose runout is not given, would print onto one another: %2.</source>
            <translation>Не рассматривались частоты вращения заготовки, при которых отношение частот ближе %1 к целому числу: там волны круга, биение которого не задано, попадали бы друг на друга: %2.</translation>
        </message>
    </context>
    <context>
        <name>OptimiseText</name>
        <message>
            <source>See the page Search of the inputs.</source>
            <translation>См. страницу «Поиск» исходных данных.</translation>
        </message>
        <message>
            <source>Of every stage: radial feed, mm per double stroke; axial feed, mm/min; stock per side, mm</source>
            <translation>Для каждой ступени: радиальная подача, мм/дв. ход; продольная подача, мм/мин; припуск на сторону, мм</translation>
        </message>
        <message>
            <source>Of every stage: radial feed, mm/min; stock per side, mm</source>
            <translation>Для каждой ступени: радиальная подача, мм/мин; припуск на сторону, мм</translation>
        </message>
        <message>
            <source>The batch that the cycle must be fit for cannot be run:</source>
            <translation>Партию, для которой цикл должен быть годен, рассчитать нельзя:</translation>
        </message>
        <message>
            <source>S_c %1</source>
            <translation>S_c %1</translation>
        </message>
        <message>
            <source>spark-out %1</source>
            <translation>выхаживание %1</translation>
        </message>
        <message>
            <source>%1 rev/min</source>
            <translation>%1 об/мин</translation>
        </message>
        <message>
            <source>dwells %1 and %2 s</source>
            <translation>выстой %1 и %2 с</translation>
        </message>
        <message>
            <source>“Search” finds the cycle of the grid with the minimum cost of a part, together with the parts between dressings: it is fit for all of them.</source>
            <translation>«Найти» ищет цикл сетки с наименьшей стоимостью детали вместе с числом деталей между правками: он годен для каждой из них.</translation>
        </message>
        <message>
            <source>“Search” finds the cycle of the grid that is fit for the most parts from one dressing to the next, the quickest of these.</source>
            <translation>«Найти» ищет цикл сетки, который годен для наибольшего числа деталей от правки до правки, из таких самый быстрый.</translation>
        </message>
        <message>
            <source>“%1”</source>
            <translation>«%1»</translation>
        </message>
        <message>
            <source>Pruned search</source>
            <translation>Поиск с отсечением</translation>
        </message>
        <message>
            <source>Full enumeration</source>
            <translation>Полный перебор</translation>
        </message>
        <message>
            <source>Dynamic programming</source>
            <translation>Динамическое программирование</translation>
        </message>
        <message>
            <source>Label-setting method</source>
            <translation>Метод меток</translation>
        </message>
        <message>
            <source>Proves from few runs that no cycle of the grid is better: cycles that cannot be fit or quicker are not run</source>
            <translation>Доказывает немногими расчётами, что лучшего цикла в сетке нет: то, что не может выдержать требования или быть быстрее, не рассчитывается</translation>
        </message>
        <message>
            <source>Runs every cycle of the grid, and proves the same answer without pruning. A large grid takes hours or days; for the minimum time and the maximum margin it can be stopped and continued</source>
            <translation>Рассчитывает все циклы сетки и доказывает тот же ответ без отсечения. Перебор большой сетки занимает часы или дни; при поиске наименьшего времени и наибольшего запаса перебор можно остановить и продолжить</translation>
        </message>
        <message>
            <source>A heuristic for plunge grinding, as published: of all paths to a level of stock with a feed only the quickest is kept. It is quick, but proves nothing and may find no cycle although one exists</source>
            <translation>Эвристика для врезного шлифования, как опубликовано: из всех путей к уровню припуска с данной подачей остаётся только самый быстрый. Работает быстро, но ничего не доказывает и может не найти существующего цикла</translation>
        </message>
        <message>
            <source>A heuristic for plunge grinding: all paths to a level of stock are kept that no other beats in both time and stored deflection. It takes longer with many levels, proves nothing and may find no cycle although one exists</source>
            <translation>Эвристика для врезного шлифования: остаются все пути к уровню припуска, которые никакой другой не превосходит сразу и по времени, и по накопленному отжатию. При многих уровнях работает дольше, ничего не доказывает и может не найти существующего цикла</translation>
        </message>
    </context>
    <context>
        <name>PageText</name>
        <message>
            <source>page %1 of %2</source>
            <translation>стр. %1 из %2</translation>
        </message>
    </context>
    <context>
        <name>PartRows</name>
        <message>
            <source>finished</source>
            <translation>готово</translation>
        </message>
        <message>
            <source>does not reach size</source>
            <translation>размер не достигается</translation>
        </message>
        <message>
            <source>strips stay uncut</source>
            <translation>остались полосы</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>да</translation>
        </message>
        <message>
            <source>no</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>Part</source>
            <translation>Деталь</translation>
        </message>
        <message>
            <source>State</source>
            <translation>Состояние</translation>
        </message>
        <message>
            <source>Good</source>
            <translation>Годна</translation>
        </message>
        <message>
            <source>Minimum margin, relative to its limit</source>
            <translation>Наименьший запас, от предела</translation>
        </message>
        <message>
            <source>%1: met</source>
            <comment>a requirement</comment>
            <translation>%1: выполнено</translation>
        </message>
        <message>
            <source>All parts of the batch</source>
            <translation>Все детали партии</translation>
        </message>
    </context>
    <context>
        <name>PartSketch</name>
        <message>
            <source>%1 mm</source>
            <translation>%1 мм</translation>
        </message>
        <message>
            <source>headstock</source>
            <translation>передняя бабка</translation>
        </message>
        <message>
            <source>tailstock</source>
            <translation>задняя бабка</translation>
        </message>
        <message>
            <source>gauge</source>
            <translation>прибор</translation>
        </message>
        <message>
            <source>Sketch of the part, not to scale across</source>
            <translation>Эскиз детали, поперёк не в масштабе</translation>
        </message>
        <message>
            <source>ground diameter %1</source>
            <translation>шлифуемый диаметр %1</translation>
        </message>
        <message>
            <source>ground length %1</source>
            <translation>шлифуемая длина %1</translation>
        </message>
        <message>
            <source>%1: %2 to %3</source>
            <comment>zone or section, from, to</comment>
            <translation>%1: от %2 до %3</translation>
        </message>
        <message>
            <source>gauge at %1</source>
            <translation>прибор на %1</translation>
        </message>
    </context>
    <context>
        <name>Passport</name>
        <message>
            <source>Accuracy passport of a grinding cycle</source>
            <translation>Паспорт точности обработки цикла шлифования</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>Drawing and part</source>
            <translation>Чертёж и деталь</translation>
        </message>
        <message>
            <source>Tooling and settings</source>
            <translation>Оснастка и режимы</translation>
        </message>
        <message>
            <source>Settings by stage</source>
            <translation>Режимы по ступеням</translation>
        </message>
        <message>
            <source>Batch: factors and scenarios</source>
            <translation>Партия: факторы и сценарии</translation>
        </message>
        <message>
            <source>Worst part of the batch</source>
            <translation>Худшая деталь партии</translation>
        </message>
        <message>
            <source>Requirements of the nominal part</source>
            <translation>Требования для номинальной детали</translation>
        </message>
        <message>
            <source>Requirements of the settings</source>
            <translation>Требования к настройке</translation>
        </message>
        <message>
            <source>Recomputing</source>
            <translation>Как повторить расчёт</translation>
        </message>
        <message>
            <source>Appendix: all inputs</source>
            <translation>Приложение: все исходные данные</translation>
        </message>
        <message>
            <source>Predicted accuracy against the drawing</source>
            <translation>Ожидаемая точность по сравнению с чертежом</translation>
        </message>
        <message>
            <source>Corner parts are not a sample: they give extremes and counts, but no mean and no capability.</source>
            <translation>Крайние сочетания — не выборка: они дают крайние значения и число деталей, но не среднее и не показатели пригодности процесса.</translation>
        </message>
        <message>
            <source>Capability and share out of tolerance</source>
            <translation>Пригодность и доля вне допуска</translation>
        </message>
        <message>
            <source>Percentiles</source>
            <translation>Квантили</translation>
        </message>
        <message>
            <source>Distribution against the tolerance band</source>
            <translation>Распределение относительно поля допуска</translation>
        </message>
        <message>
            <source>Nominal part at the end of the cycle</source>
            <translation>Номинальная деталь в конце цикла</translation>
        </message>
        <message>
            <source>Values based on estimates</source>
            <translation>Что опирается на оценки</translation>
        </message>
        <message>
            <source>Remarks</source>
            <translation>Замечания</translation>
        </message>
        <message>
            <source>Notes</source>
            <translation>Примечания</translation>
        </message>
        <message>
            <source>–: with so few values it would be the smallest or the largest one.</source>
            <translation>–: при таком числе значений это было бы наименьшее или наибольшее из них.</translation>
        </message>
        <message>
            <source>Calibrated inputs</source>
            <translation>Откалиброванные исходные данные</translation>
        </message>
        <message>
            <source>A cycle not used for the calibration</source>
            <translation>Цикл, не использованный при калибровке</translation>
        </message>
        <message>
            <source>Measured parts against the prediction</source>
            <translation>Измеренные детали и прогноз</translation>
        </message>
        <message>
            <source>Wheel between dressings</source>
            <translation>Круг между правками</translation>
        </message>
    </context>
    <context>
        <name>WorkedStep</name>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>Stage</source>
            <translation>Ступень</translation>
        </message>
        <message>
            <source>Double stroke</source>
            <translation>Двойной ход</translation>
        </message>
        <message>
            <source>Revolution</source>
            <translation>Оборот</translation>
        </message>
        <message>
            <source>Step</source>
            <translation>Этап</translation>
        </message>
        <message>
            <source>Revolution of the step</source>
            <translation>Оборот этапа</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>Радиус</translation>
        </message>
        <message>
            <source>Effective width b</source>
            <translation>Эффективная ширина резания b</translation>
        </message>
        <message>
            <source>Programmed so far, tП</source>
            <translation>Накопленная программная подача tП</translation>
        </message>
        <message>
            <source>Actual feed a</source>
            <translation>Фактическая подача a</translation>
        </message>
        <message>
            <source>Stock left at this radius</source>
            <translation>Оставшийся припуск на этом радиусе</translation>
        </message>
        <message>
            <source>The forces are those at the depth of cut of the elastic balance below.</source>
            <translation>Силы вычислены для той фактической подачи, которую даёт упругий баланс, приведённый ниже.</translation>
        </message>
        <message>
            <source>Limits of the feed at this step</source>
            <translation>Что ограничивает подачу на этом шаге</translation>
        </message>
        <message>
            <source>No other requirement of this project limits the feed.</source>
            <translation>Других требований, ограничивающих подачу, в проекте нет.</translation>
        </message>
        <message>
            <source>No requirement of this project limits the feed.</source>
            <translation>Ни одно требование этого проекта не ограничивает подачу.</translation>
        </message>
        <message>
            <source>Each requirement allows a maximum depth of cut; the formulas below show its origin. Roughness limits only the last cut of the cycle.</source>
            <translation>Каждое требование допускает свою наибольшую фактическую подачу; откуда она берётся, показывают формулы ниже. Шероховатость ограничивает только последний срез цикла.</translation>
        </message>
        <message>
            <source>Each requirement allows a maximum depth of cut; the formulas below show its origin.</source>
            <translation>Каждое требование допускает свою наибольшую подачу; откуда она берётся, показывают формулы ниже.</translation>
        </message>
        <message>
            <source>Requirement</source>
            <translation>Требование</translation>
        </message>
        <message>
            <source>Limiting depth of cut, µm</source>
            <translation>Предельная фактическая подача, мкм</translation>
        </message>
        <message>
            <source>As a feed, mm/min</source>
            <translation>Скорость подачи, мм/мин</translation>
        </message>
        <message>
            <source>Depth of cut of the step, µm</source>
            <translation>Фактическая подача шага, мкм</translation>
        </message>
        <message>
            <source>Share of the limit, %</source>
            <translation>Доля предела, %</translation>
        </message>
        <message>
            <source>not met at any depth</source>
            <translation>не выполнено ни при какой подаче</translation>
        </message>
    </context>
    <context>
        <name>PassportVerdict</name>
        <message>
            <source>Prediction</source>
            <translation>Прогноз</translation>
        </message>
        <message>
            <source>all requirements are met; no batch is described, so scatter is not assessed</source>
            <translation>все проверенные требования выполнены; партия не описана, поэтому рассеяние не учтено</translation>
        </message>
        <message>
            <source>The cycle, by the prediction</source>
            <translation>Цикл по результатам расчёта</translation>
        </message>
        <message>
            <source>Deciding result</source>
            <translation>Чем определено</translation>
        </message>
        <message>
            <source>Rejected parts</source>
            <translation>Негодных деталей</translation>
        </message>
        <message>
            <source>Not counted in the batch</source>
            <translation>Не учтено в партии</translation>
        </message>
        <message>
            <source>Minimum Ppk</source>
            <translation>Наименьший Ppk</translation>
        </message>
        <message>
            <source>%1: out of tolerance %2.</source>
            <translation>%1: вне допуска %2.</translation>
        </message>
        <message>
            <source>Worst part, number %1: %2.</source>
            <translation>Худшая деталь, номер %1: %2.</translation>
        </message>
        <message>
            <source>no batch is described</source>
            <translation>партия не описана</translation>
        </message>
        <message>
            <source>Machining time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>This is the prediction of a model, to be confirmed at the machine; it is not an assessment of conformity and does not replace measurement.</source>
            <translation>Это результат расчёта по модели, который следует подтвердить на станке; он не является подтверждением соответствия и не заменяет измерений.</translation>
        </message>
        <message>
            <source>The cycle is fit when every stock within one infeed, where that is decided, and every part that was run reach size and meet every requirement, and the lower 95 % bounds of all Ppk reach %1; it is conditionally fit when no more parts are rejected than the share allowed, or when a requirement, the capability or the expected share outside is not decided or falls short. %2</source>
            <translation>Цикл годен, если при каждом припуске в пределах подачи на шаг, где это решается, и у каждой рассчитанной детали партии достигнут размер и выполнены все требования, а нижние 95%-ные границы всех Ppk не меньше %1; он условно годен, если доля негодных деталей не больше допущенной либо если требование, пригодность процесса или ожидаемая доля вне допуска не определены или недостаточны. %2</translation>
        </message>
        <message>
            <source>Without a batch the cycle is conditionally fit when every stock within one infeed, where that is decided, reaches size and meets every requirement. %1</source>
            <translation>Без партии цикл условно годен, если при каждом припуске в пределах подачи на шаг, где это решается, достигнут размер и выполнены все требования. %1</translation>
        </message>
    </context>
    <context>
        <name>PassportPrediction</name>
        <message>
            <source>It meets all requirements</source>
            <translation>Все требования выполнены</translation>
        </message>
        <message>
            <source>Characteristic</source>
            <translation>Характеристика</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Limits</source>
            <translation>Пределы</translation>
        </message>
        <message>
            <source>Nominal part</source>
            <translation>Номинал</translation>
        </message>
        <message>
            <source>Min.</source>
            <translation>Наим.</translation>
        </message>
        <message>
            <source>Mean</source>
            <translation>Среднее</translation>
        </message>
        <message>
            <source>Max.</source>
            <translation>Наиб.</translation>
        </message>
        <message>
            <source>s</source>
            <translation>s</translation>
        </message>
        <message>
            <source>Mean, 95 %</source>
            <translation>Среднее, 95 %</translation>
        </message>
        <message>
            <source>Pp</source>
            <translation>Pp</translation>
        </message>
        <message>
            <source>Ppk</source>
            <translation>Ppk</translation>
        </message>
        <message>
            <source>Out of tolerance</source>
            <translation>Вне допуска</translation>
        </message>
        <message numerus="yes">
            <source>Of the %n part(s) number %1 has the minimum margin. %2.</source>
            <translation>
                <numerusform>Из %n детали наименьший запас у детали номер %1. %2.</numerusform>
                <numerusform>Из %n деталей наименьший запас у детали номер %1. %2.</numerusform>
                <numerusform>Из %n деталей наименьший запас у детали номер %1. %2.</numerusform>
            </translation>
        </message>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>Requirement</source>
            <translation>Требование</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>Предел</translation>
        </message>
        <message>
            <source>Margin</source>
            <translation>Запас</translation>
        </message>
        <message>
            <source>Where in the cycle</source>
            <translation>Место в цикле</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>Stage or cycle</source>
            <translation>Ступень или цикл</translation>
        </message>
        <message>
            <source>at the end</source>
            <translation>в конце</translation>
        </message>
    </context>
    <context>
        <name>PassportInputs</name>
        <message>
            <source>Correlation</source>
            <translation>Корреляция</translation>
        </message>
        <message>
            <source>constant %1</source>
            <translation>постоянная величина %1</translation>
        </message>
        <message>
            <source>uniform, %1</source>
            <translation>равномерное, %1</translation>
        </message>
        <message>
            <source>normal, mean %1, standard deviation %2</source>
            <translation>нормальное, среднее %1, стандартное отклонение %2</translation>
        </message>
        <message>
            <source>%1, truncated to %2</source>
            <comment>normal distribution</comment>
            <translation>%1, усечено до %2</translation>
        </message>
        <message>
            <source>triangular, %1, most frequent %2</source>
            <translation>треугольное, %1, наиболее частое %2</translation>
        </message>
        <message numerus="yes">
            <source>as measured, %n value(s), %1</source>
            <translation>
                <numerusform>по измерениям, %n значение, %1</numerusform>
                <numerusform>по измерениям, %n значения, %1</numerusform>
                <numerusform>по измерениям, %n значений, %1</numerusform>
            </translation>
        </message>
        <message>
            <source>grows part by part from %1 to %2</source>
            <translation>растёт от детали к детали с %1 до %2</translation>
        </message>
        <message numerus="yes">
            <source>%1, %n part(s) between settings of the gauge</source>
            <translation>
                <numerusform>%1, между настройками прибора %n деталь</numerusform>
                <numerusform>%1, между настройками прибора %n детали</numerusform>
                <numerusform>%1, между настройками прибора %n деталей</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1, %n part(s) between dressings</source>
            <translation>
                <numerusform>%1, между правками %n деталь</numerusform>
                <numerusform>%1, между правками %n детали</numerusform>
                <numerusform>%1, между правками %n деталей</numerusform>
            </translation>
        </message>
        <message>
            <source>%1 over the whole batch</source>
            <translation>%1 по всей партии</translation>
        </message>
        <message>
            <source>This project describes no batch, so the passport covers only the nominal part: it gives no scatter, no capability and no share out of tolerance.</source>
            <translation>В проекте не описана партия, поэтому паспорт содержит только расчёт номинальной детали: без рассеяния, без показателей пригодности процесса и без доли вне допуска.</translation>
        </message>
        <message>
            <source>A batch is added on the page Batch of the inputs, where each factor that scatters gets its distribution, or with “Add a typical batch” in the view Batch.</source>
            <translation>Партию добавляют на странице «Партия» исходных данных, где каждому рассеивающемуся фактору задают распределение, или кнопкой «Добавить типовую партию» вида «Партия».</translation>
        </message>
        <message>
            <source>Parts run</source>
            <translation>Рассчитано деталей</translation>
        </message>
        <message>
            <source>Scenarios</source>
            <translation>Сценарии</translation>
        </message>
        <message>
            <source>Seed</source>
            <translation>Номер выборки</translation>
        </message>
        <message>
            <source>none is drawn</source>
            <translation>случайных чисел нет</translation>
        </message>
        <message>
            <source>Correlation of the factors</source>
            <translation>Корреляция факторов</translation>
        </message>
        <message>
            <source>as in the table below</source>
            <translation>по таблице ниже</translation>
        </message>
        <message>
            <source>independent</source>
            <translation>независимы</translation>
        </message>
        <message>
            <source>Factor</source>
            <translation>Фактор</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Distribution</source>
            <translation>Распределение</translation>
        </message>
        <message>
            <source>Minimum tried</source>
            <translation>Наименьшее из испытанных</translation>
        </message>
        <message>
            <source>Maximum tried</source>
            <translation>Наибольшее из испытанных</translation>
        </message>
        <message numerus="yes">
            <source>Minimum and maximum tried: of the first %n parts.</source>
            <translation>
                <numerusform>Наименьшее и наибольшее из испытанных — по первой %n детали.</numerusform>
                <numerusform>Наименьшее и наибольшее из испытанных — по первым %n деталям.</numerusform>
                <numerusform>Наименьшее и наибольшее из испытанных — по первым %n деталям.</numerusform>
            </translation>
        </message>
        <message>
            <source>Input</source>
            <translation>Исходная величина</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Program</source>
            <translation>Программа</translation>
        </message>
        <message>
            <source>Version of the engine</source>
            <translation>Версия расчётного ядра</translation>
        </message>
        <message>
            <source>Extent of the run</source>
            <translation>Что рассчитано</translation>
        </message>
        <message>
            <source>Command to recompute it</source>
            <translation>Команда, повторяющая расчёт</translation>
        </message>
        <message>
            <source>The same inputs and the same seed give the same numbers, with any number of threads. All that the computation reads is in the appendix, each number with all its digits.</source>
            <translation>Те же исходные данные и тот же номер выборки дают те же результаты при любом числе потоков. Всё, что читает расчёт, приведено в приложении, каждое число — со всеми знаками.</translation>
        </message>
        <message>
            <source>The same inputs give the same numbers. All that the computation reads is in the appendix, each number with all its digits.</source>
            <translation>Те же исходные данные дают те же результаты. Всё, что читает расчёт, приведено в приложении, каждое число — со всеми знаками.</translation>
        </message>
    </context>
    <context>
        <name>PassportFigures</name>
        <message>
            <source>%1: %2</source>
            <comment>zone, range of values</comment>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>%1: number of parts, where the Ppk is lowest</source>
            <translation>%1: число деталей, где Ppk наименьший</translation>
        </message>
        <message>
            <source>%1: number of parts</source>
            <translation>%1: число деталей</translation>
        </message>
        <message>
            <source>Diameter along the part against the tolerance band</source>
            <translation>Диаметр вдоль детали в поле допуска</translation>
        </message>
        <message>
            <source>Cross-sections, deviations magnified</source>
            <translation>Поперечные сечения, отклонения увеличены</translation>
        </message>
    </context>
    <context>
        <name>CapabilityChart</name>
        <message>
            <source>Ppk with its 95 % bounds, the smallest first; dashed: 1 and %1</source>
            <translation>Ppk с 95%-ными границами, начиная с наименьшего; штрихами — 1 и %1</translation>
        </message>
    </context>
    <context>
        <name>ProfileCsv</name>
        <message>
            <source>line %1: “%2” cannot be read as a number</source>
            <translation>строка %1: «%2» не читается как число</translation>
        </message>
        <message>
            <source>line %1: “%2” is out of range; allowed: %3</source>
            <translation>строка %1: значение «%2» вне допустимых пределов; допускается: %3</translation>
        </message>
        <message numerus="yes">
            <source>it holds %n values; needed: an even number, %1</source>
            <translation>
                <numerusform>в нём %n значение; нужно чётное количество: %1</numerusform>
                <numerusform>в нём %n значения; нужно чётное количество: %1</numerusform>
                <numerusform>в нём %n значений; нужно чётное количество: %1</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>ProfileLook</name>
        <message>
            <source>profile, along the axis its mean</source>
            <translation>профиль, вдоль оси — его среднее</translation>
        </message>
        <message>
            <source>minimum…maximum over the radii</source>
            <translation>наименьший…наибольший по радиусам</translation>
        </message>
        <message>
            <source>blank</source>
            <translation>заготовка</translation>
        </message>
        <message>
            <source>target radius</source>
            <translation>целевой радиус</translation>
        </message>
        <message>
            <source>least-squares circle</source>
            <translation>средняя окружность (МНК)</translation>
        </message>
        <message>
            <source>tolerance band</source>
            <translation>поле допуска</translation>
        </message>
        <message>
            <source>gauge</source>
            <translation>ПАК</translation>
        </message>
        <message>
            <source>circles of the minimum zone</source>
            <translation>окружности минимальной зоны</translation>
        </message>
        <message>
            <source>maximum inscribed circle</source>
            <translation>максимальная вписанная окружность</translation>
        </message>
        <message>
            <source>minimum circumscribed circle</source>
            <translation>минимальная описанная окружность</translation>
        </message>
    </context>
    <context>
        <name>ProfilesTable</name>
        <message>
            <source>radius no.</source>
            <translation>№ радиуса</translation>
        </message>
        <message>
            <source>angle, °</source>
            <translation>угол, °</translation>
        </message>
        <message>
            <source>blank: radius from target, µm</source>
            <translation>заготовка: радиус от целевого, мкм</translation>
        </message>
        <message>
            <source>%1: radius from target, µm</source>
            <translation>%1: радиус от целевого, мкм</translation>
        </message>
        <message>
            <source>%1: least-squares circle from target, µm</source>
            <translation>%1: средняя окружность (МНК) от целевого, мкм</translation>
        </message>
        <message>
            <source>radius, mm</source>
            <translation>радиус, мм</translation>
        </message>
        <message>
            <source>diameter from nominal, µm</source>
            <translation>диаметр от номинала, мкм</translation>
        </message>
        <message>
            <source>radius from target, µm</source>
            <translation>радиус от целевого, мкм</translation>
        </message>
        <message>
            <source>mean %1</source>
            <translation>средний %1</translation>
        </message>
        <message>
            <source>minimum %1</source>
            <translation>наименьший %1</translation>
        </message>
        <message>
            <source>maximum %1</source>
            <translation>наибольший %1</translation>
        </message>
        <message>
            <source>blank, minimum %1</source>
            <translation>заготовка, наименьший %1</translation>
        </message>
        <message>
            <source>blank, maximum %1</source>
            <translation>заготовка, наибольший %1</translation>
        </message>
        <message>
            <source>target %1</source>
            <translation>целевой %1</translation>
        </message>
        <message>
            <source>lower limit %1</source>
            <translation>нижняя граница: %1</translation>
        </message>
        <message>
            <source>upper limit %1</source>
            <translation>верхняя граница: %1</translation>
        </message>
        <message>
            <source>zone</source>
            <translation>зона</translation>
        </message>
        <message>
            <source>section</source>
            <translation>сечение</translation>
        </message>
        <message>
            <source>from, mm</source>
            <translation>от, мм</translation>
        </message>
        <message>
            <source>middle, mm</source>
            <translation>середина, мм</translation>
        </message>
        <message>
            <source>to, mm</source>
            <translation>до, мм</translation>
        </message>
        <message>
            <source>%1: inner circle of the minimum zone from target, µm</source>
            <translation>%1: внутренняя окружность минимальной зоны от целевого, мкм</translation>
        </message>
        <message>
            <source>%1: outer circle of the minimum zone from target, µm</source>
            <translation>%1: наружная окружность минимальной зоны от целевого, мкм</translation>
        </message>
        <message>
            <source>%1: maximum inscribed circle from target, µm</source>
            <translation>%1: максимальная вписанная окружность от целевого, мкм</translation>
        </message>
        <message>
            <source>%1: minimum circumscribed circle from target, µm</source>
            <translation>%1: минимальная описанная окружность от целевого, мкм</translation>
        </message>
        <message>
            <source>%1: angle, °</source>
            <translation>%1: угол, °</translation>
        </message>
    </context>
    <context>
        <name>ProfilesText</name>
        <message>
            <source>; blank %1 µm from target</source>
            <translation>; заготовка %1 мкм от целевого</translation>
        </message>
        <message>
            <source>runout %1 µm</source>
            <translation>биение %1 мкм</translation>
        </message>
        <message>
            <source>✗ Diameter %1 µm: outside the field</source>
            <translation>✗ Диаметр %1 мкм: вне поля допуска</translation>
        </message>
        <message>
            <source>✓ Diameter %1 µm: in the field</source>
            <translation>✓ Диаметр %1 мкм: в поле допуска</translation>
        </message>
        <message>
            <source>strips uncut</source>
            <translation>полосы</translation>
        </message>
        <message>
            <source>Strips stay uncut: size and form are not known</source>
            <translation>Остаются непрошлифованные полосы: размер и форма неизвестны</translation>
        </message>
        <message>
            <source>Radial runout %1 µm</source>
            <translation>Радиальное биение %1 мкм</translation>
        </message>
        <message>
            <source>%1, φ = %2° (k = %3): radius %4 µm from target, %5 µm from its mean; diameter across %6 mm, %7 µm from nominal</source>
            <translation>%1, φ = %2° (k = %3): радиус %4 мкм от целевого, %5 мкм от среднего; диаметр здесь %6 мм, %7 мкм от номинала</translation>
        </message>
        <message>
            <source>%1 mm</source>
            <translation>%1 мм</translation>
        </message>
        <message>
            <source>%1…%2 mm</source>
            <translation>%1…%2 мм</translation>
        </message>
        <message>
            <source>%1, %2: radius %3 µm from target, mean %4 µm; diameter %5 µm from nominal; runout %6 µm</source>
            <translation>%1, %2: радиус %3 мкм от целевого, средний %4 мкм; диаметр %5 мкм от номинала; биение %6 мкм</translation>
        </message>
        <message>
            <source>%1, stage %2</source>
            <translation>%1, ступень %2</translation>
        </message>
        <message>
            <source>%1, %2 s</source>
            <translation>%1, %2 с</translation>
        </message>
        <message>
            <source>%1. %2</source>
            <translation>%1. %2</translation>
        </message>
        <message>
            <source>RONt %1, e %2 µm</source>
            <translation>RONt %1, e %2 мкм</translation>
        </message>
        <message>
            <source>RONt %1 µm, eccentricity %2 µm</source>
            <translation>RONt %1 мкм, эксцентриситет %2 мкм</translation>
        </message>
        <message>
            <source>ΔD %1 %2</source>
            <comment>deviations of the diameter in µm, short; then ✓ or ✗</comment>
            <translation>ΔD %1 %2</translation>
        </message>
        <message>
            <source>%1, φ = %2° (k = %3): in a gap of the surface</source>
            <translation>%1, φ = %2° (k = %3): в пазу поверхности</translation>
        </message>
        <message>
            <source>%1, φ = %2° (k = %3): radius %4 µm from target, %5 µm from its mean; opposite a gap</source>
            <translation>%1, φ = %2° (k = %3): радиус %4 мкм от целевого, %5 мкм от среднего; напротив паза</translation>
        </message>
        <message>
            <source>; cylindricity %1 µm, total runout %2 µm, taper %3 µm</source>
            <translation>; отклонение от цилиндричности %1 мкм, полное радиальное биение %2 мкм, конусообразность %3 мкм</translation>
        </message>
        <message>
            <source>%1 radii, from own mean</source>
            <translation>%1 радиусов, от своего среднего</translation>
        </message>
        <message>
            <source>Gaussian filter %1 UPR</source>
            <translation>фильтр Гаусса %1 волн/об</translation>
        </message>
        <message>
            <source>not filtered</source>
            <translation>без фильтра</translation>
        </message>
    </context>
    <context>
        <name>Range</name>
        <message>
            <source>above %1, up to %2</source>
            <translation>больше %1, до %2</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <translation>от %1 до %2</translation>
        </message>
        <message>
            <source>above %1</source>
            <translation>больше %1</translation>
        </message>
        <message>
            <source>at least %1</source>
            <translation>не менее %1</translation>
        </message>
        <message>
            <source>at most %1</source>
            <translation>не более %1</translation>
        </message>
    </context>
    <context>
        <name>ReportKind</name>
        <message>
            <source>Cycle car&amp;d</source>
            <translation>&amp;Карта цикла</translation>
        </message>
        <message>
            <source>Accuracy &amp;passport</source>
            <translation>&amp;Паспорт точности</translation>
        </message>
        <message>
            <source>Course &amp;hand-out</source>
            <translation>&amp;Раздаточный материал</translation>
        </message>
        <message>
            <source>&amp;Operation card</source>
            <translation>&amp;Операционная карта</translation>
        </message>
        <message>
            <source>S&amp;ketch sheet</source>
            <translation>Карта &amp;эскизов</translation>
        </message>
    </context>
    <context>
        <name>Requirement</name>
        <message>
            <source>Minimum diameter</source>
            <translation>Наим. диаметр</translation>
        </message>
        <message>
            <source>diameter in %1 is %2 µm below the lower limit</source>
            <translation>диаметр (%1) на %2 мкм меньше нижнего предела</translation>
        </message>
        <message>
            <source>Maximum diameter</source>
            <translation>Наиб. диаметр</translation>
        </message>
        <message>
            <source>diameter in %1 is %2 µm above the upper limit</source>
            <translation>диаметр (%1) на %2 мкм больше верхнего предела</translation>
        </message>
        <message>
            <source>Radial runout</source>
            <translation>Радиальное биение</translation>
        </message>
        <message>
            <source>radial runout in %1 is %2 µm above its limit</source>
            <translation>радиальное биение (%1) на %2 мкм больше допуска</translation>
        </message>
        <message>
            <source>Roundness</source>
            <translation>Отклонение от круглости</translation>
        </message>
        <message>
            <source>Between the circles of the minimum zone, MZCI (ISO 12181)</source>
            <translation>По окружностям минимальной зоны (ISO 12181)</translation>
        </message>
        <message>
            <source>Cylindricity</source>
            <translation>Отклонение от цилиндричности</translation>
        </message>
        <message>
            <source>Between the cylinders of the minimum zone, MZCY (ISO 12180)</source>
            <translation>По цилиндрам минимальной зоны (ISO 12180)</translation>
        </message>
        <message>
            <source>Total runout</source>
            <translation>Полное радиальное биение</translation>
        </message>
        <message>
            <source>Roughness Ra</source>
            <translation>Шероховатость Ra</translation>
        </message>
        <message>
            <source>Ra, last cut</source>
            <translation>Ra, посл. проход</translation>
        </message>
        <message>
            <source>Depth of cut without burn</source>
            <translation>Глубина резания без прижога</translation>
        </message>
        <message>
            <source>burn</source>
            <translation>прижог</translation>
        </message>
        <message>
            <source>Contact pressure on the wheel</source>
            <translation>Давление на круг в контакте</translation>
        </message>
        <message>
            <source>self-sharpening</source>
            <translation>самозатачивание</translation>
        </message>
        <message>
            <source>Wheel drive power</source>
            <translation>Мощность привода круга</translation>
        </message>
        <message>
            <source>wheel drive</source>
            <translation>привод круга</translation>
        </message>
        <message>
            <source>Work drive power</source>
            <translation>Мощность привода изделия</translation>
        </message>
        <message>
            <source>work drive</source>
            <translation>привод изделия</translation>
        </message>
        <message>
            <source>Radial feed in range</source>
            <translation>Радиальная подача в диапазоне</translation>
        </message>
        <message>
            <source>Axial feed in range</source>
            <translation>Продольная подача в диапазоне</translation>
        </message>
        <message>
            <source>Plunge feed in range</source>
            <translation>Врезная подача в диапазоне</translation>
        </message>
        <message>
            <source>Continuous infeed in range</source>
            <translation>Непрерывная подача в диапазоне</translation>
        </message>
        <message>
            <source>Work speed in range</source>
            <translation>Частота вращения заготовки в диапазоне</translation>
        </message>
        <message>
            <source>Gauge commands</source>
            <translation>Число команд прибора</translation>
        </message>
        <message>
            <source>the stages need %2 more gauge commands than available</source>
            <translation>ступеням не хватает команд прибора: %2</translation>
        </message>
        <message>
            <source>Overlap of the turns</source>
            <translation>Перекрытие витков</translation>
        </message>
        <message>
            <source>overlap B/s in %1 is %3, below 1: strips stay uncut, so size, form and roughness are not known for the whole surface</source>
            <translation>коэффициент перекрытия B/s (%1) равен %3, меньше 1: остаются непрошлифованные полосы, поэтому размер, форма и шероховатость всей поверхности неизвестны</translation>
        </message>
        <message>
            <source>Required overlap of a stage</source>
            <translation>Коэффициент перекрытия ступени</translation>
        </message>
        <message>
            <source>overlap B/s in %1 is %3, %2 below the minimum</source>
            <translation>коэффициент перекрытия B/s (%1) равен %3, на %2 меньше наименьшего</translation>
        </message>
        <message>
            <source>Required overlap of the last stage</source>
            <translation>Коэффициент перекрытия последней ступени</translation>
        </message>
        <message>
            <source>overlap B/s in the last stage is %3, %2 below the minimum</source>
            <translation>коэффициент перекрытия B/s последней ступени равен %3, на %2 меньше наименьшего</translation>
        </message>
        <message>
            <source>Steps of a stage</source>
            <translation>Число двойных ходов (оборотов) ступени</translation>
        </message>
        <message>
            <source>%1 makes %3 double strokes or revolutions, %2 fewer than the minimum</source>
            <translation>%1: двойных ходов (оборотов) %3, на %2 меньше наименьшего числа</translation>
        </message>
        <message>
            <source>Waviness</source>
            <translation>Волнистость</translation>
        </message>
        <message>
            <source>From peak to valley, without the orders below half of the wheel&apos;s</source>
            <translation>От вершины до впадины, без гармоник ниже половины порядка круга</translation>
        </message>
    </context>
    <context>
        <name>RequirementBrief</name>
        <message>
            <source>Min. diameter</source>
            <translation>d наим.</translation>
        </message>
        <message>
            <source>Max. diameter</source>
            <translation>d наиб.</translation>
        </message>
        <message>
            <source>Radial runout</source>
            <translation>Рад. биение</translation>
        </message>
        <message>
            <source>Roundness</source>
            <translation>Откл. от круглости</translation>
        </message>
        <message>
            <source>Cylindricity</source>
            <translation>Откл. от цилиндр.</translation>
        </message>
        <message>
            <source>Total runout</source>
            <translation>Полное биение</translation>
        </message>
        <message>
            <source>Roughness Ra</source>
            <translation>Ra</translation>
        </message>
        <message>
            <source>Depth, burn</source>
            <translation>Глубина, прижог</translation>
        </message>
        <message>
            <source>Pressure</source>
            <translation>Давление</translation>
        </message>
        <message>
            <source>Wheel power</source>
            <translation>Привод круга</translation>
        </message>
        <message>
            <source>Work power</source>
            <translation>Привод изделия</translation>
        </message>
        <message>
            <source>Radial feed</source>
            <translation>Рад. подача</translation>
        </message>
        <message>
            <source>Axial feed</source>
            <translation>Прод. подача</translation>
        </message>
        <message>
            <source>Plunge feed</source>
            <translation>Врезание</translation>
        </message>
        <message>
            <source>Cont. infeed</source>
            <translation>Непр. подача</translation>
        </message>
        <message>
            <source>Work speed</source>
            <translation>Частота n</translation>
        </message>
        <message>
            <source>Gauge commands</source>
            <translation>Команды ПАК</translation>
        </message>
        <message>
            <source>Overlap</source>
            <translation>Перекрытие витков</translation>
        </message>
        <message>
            <source>Minimum overlap</source>
            <translation>Коэф. перекрытия</translation>
        </message>
        <message>
            <source>Overlap, last</source>
            <translation>Коэф. перекр., посл.</translation>
        </message>
        <message>
            <source>Fewest steps</source>
            <translation>Число ходов</translation>
        </message>
        <message>
            <source>Waviness</source>
            <translation>Волнистость</translation>
        </message>
    </context>
    <context>
        <name>ResultParts</name>
        <message>
            <source>Gauge reading, diameter</source>
            <translation>Показание прибора, диаметр</translation>
        </message>
        <message>
            <source>Stock left per side by the gauge</source>
            <translation>Остаток припуска на сторону по прибору</translation>
        </message>
        <message>
            <source>Taper</source>
            <translation>Конусообразность</translation>
        </message>
        <message>
            <source>Crown</source>
            <translation>Бочкообразность</translation>
        </message>
        <message>
            <source>Engine</source>
            <translation>Версия расчёта</translation>
        </message>
        <message>
            <source>Radius no.</source>
            <translation>Радиус №</translation>
        </message>
        <message>
            <source>Angle, °</source>
            <translation>Угол, °</translation>
        </message>
        <message>
            <source>%1: radius from nominal, µm</source>
            <translation>%1: радиус от номинала, мкм</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Исходные данные</translation>
        </message>
        <message>
            <source>Whole cycle</source>
            <translation>Весь цикл</translation>
        </message>
        <message>
            <source>Stages</source>
            <translation>Ступени</translation>
        </message>
        <message>
            <source>Zones</source>
            <translation>Зоны</translation>
        </message>
        <message>
            <source>Sections</source>
            <translation>Сечения</translation>
        </message>
        <message>
            <source>Final profiles</source>
            <translation>Конечные профили</translation>
        </message>
        <message>
            <source>Requirements</source>
            <translation>Требования</translation>
        </message>
        <message>
            <source>Trace</source>
            <translation>Трасса</translation>
        </message>
    </context>
    <context>
        <name>ResultTables</name>
        <message>
            <source>Requirement</source>
            <translation>Требование</translation>
        </message>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>Предел</translation>
        </message>
        <message>
            <source>Margin</source>
            <translation>Запас</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Used up, %</source>
            <translation>Занято, %</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>Worst place</source>
            <translation>Худшее место</translation>
        </message>
        <message>
            <source>Setting / nearer end of the range</source>
            <translation>Настройка / ближний предел диапазона</translation>
        </message>
        <message>
            <source>Quantity</source>
            <translation>Показатель</translation>
        </message>
    </context>
    <context>
        <name>RunTable</name>
        <message>
            <source>%1 %</source>
            <translation>%1 %</translation>
        </message>
        <message>
            <source>Margin › %1</source>
            <translation>Запас › %1</translation>
        </message>
        <message>
            <source>%1, %2: %3</source>
            <translation>%1, %2: %3</translation>
        </message>
        <message>
            <source>Worst margin</source>
            <translation>Наименьший запас</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>Stage %1 › Double strokes or revolutions</source>
            <translation>Ступень %1 › Двойные ходы или обороты</translation>
        </message>
        <message>
            <source>no longer there</source>
            <translation>больше не определяется</translation>
        </message>
        <message>
            <source>by up to %1</source>
            <translation>до %1</translation>
        </message>
        <message>
            <source>another number of values</source>
            <translation>другое число значений</translation>
        </message>
        <message>
            <source>Input</source>
            <translation>Исходная величина</translation>
        </message>
        <message>
            <source>Symbol</source>
            <translation>Обозначение</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Key in the file</source>
            <translation>Ключ в файле</translation>
        </message>
        <message>
            <source>Quantity</source>
            <translation>Показатель</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Исходные данные</translation>
        </message>
        <message>
            <source>Results</source>
            <translation>Результаты</translation>
        </message>
    </context>
    <context>
        <name>SaveDialog</name>
        <message>
            <source>The file was not saved</source>
            <translation>Файл не сохранён</translation>
        </message>
        <message>
            <source>Choose &amp;another place…</source>
            <translation>Выбрать &amp;другое место…</translation>
        </message>
        <message>
            <source>C&amp;lose</source>
            <translation>&amp;Закрыть</translation>
        </message>
        <message>
            <source>The document, picture or table could not be made.</source>
            <translation>Не удалось построить документ, рисунок или таблицу.</translation>
        </message>
    </context>
    <context>
        <name>ShopText</name>
        <message>
            <source>%1 kJ for %2 mm³ in %3 of grinding</source>
            <translation>%1 кДж на %2 мм³ за %3 шлифования</translation>
        </message>
        <message>
            <source>a = %1 µm: %2</source>
            <translation>a = %1 мкм: %2</translation>
        </message>
        <message>
            <source>below the usual</source>
            <translation>ниже обычного</translation>
        </message>
        <message>
            <source>above the usual</source>
            <translation>выше обычного</translation>
        </message>
        <message>
            <source>Quantity</source>
            <translation>Показатель</translation>
        </message>
        <message>
            <source>Outside the usual</source>
            <translation>Вне обычного</translation>
        </message>
        <message>
            <source>Stage %1</source>
            <translation>Ступень %1</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Цикл</translation>
        </message>
        <message>
            <source>Whole cycle</source>
            <translation>Весь цикл</translation>
        </message>
        <message>
            <source>near a whole number</source>
            <translation>почти целое число</translation>
        </message>
        <message>
            <source>Stage</source>
            <translation>Ступень</translation>
        </message>
        <message>
            <source>Specific energy below %2 J/mm³ (stage %1) is implausibly low; the wheel&apos;s dullness or the flow stress may be set too low.</source>
            <translation>Удельная энергия ниже %2 Дж/мм³ (ступень %1): неправдоподобно мало; возможно, занижены степень затупления круга или интенсивность напряжений.</translation>
        </message>
        <message>
            <source>Specific energy above %2 J/mm³ (stage %1): the wheel rubs more than it cuts, as it does late in spark-out or when dull.</source>
            <translation>Удельная энергия выше %2 Дж/мм³ (ступень %1): круг больше трёт, чем режет, как в конце выхаживания или при затуплении.</translation>
        </message>
        <message>
            <source>Overlap below 1 (stage %1): the table advances more than the wheel&apos;s width in a revolution, strips stay unground.</source>
            <translation>Коэффициент перекрытия меньше 1 (ступень %1): стол за оборот проходит больше высоты круга, остаются непрошлифованные полосы.</translation>
        </message>
        <message>
            <source>Wheel and work turn %1 : 1, near a whole number: waves of the wheel print onto one another. Change the work speed a little.</source>
            <translation>Круг и деталь вращаются как %1 : 1, почти целое число: волны от круга ложатся одна на другую. Немного измените частоту вращения заготовки.</translation>
        </message>
    </context>
    <context>
        <name>SizeField</name>
        <message>
            <source>This is not a size with a tolerance class; write it like 30h6.</source>
            <translation>Это не размер с полем допуска; пишите, например, 30h6.</translation>
        </message>
        <message>
            <source>Small letters are for shafts; this surface is a bore.</source>
            <translation>Строчные буквы — для валов, а эта поверхность — отверстие.</translation>
        </message>
        <message>
            <source>Capital letters are for bores; this surface is a shaft.</source>
            <translation>Прописные буквы — для отверстий, а эта поверхность — вал.</translation>
        </message>
        <message>
            <source>ISO 286 does not have this class here: sizes to 500 mm, grades 4 to 14, letters d to p.</source>
            <translation>Такого поля здесь нет: по ISO 286 размеры до 500 мм, квалитеты 4–14, буквы от d до p.</translation>
        </message>
        <message>
            <source>∅%1 mm, upper %2 µm, lower %3 µm</source>
            <translation>∅%1 мм, верхнее %2 мкм, нижнее %3 мкм</translation>
        </message>
    </context>
    <context>
        <name>Source</name>
        <message>
            <source>model page, section 1: symbols and units</source>
            <translation>описание модели, раздел 1: обозначения и единицы</translation>
        </message>
        <message>
            <source>model page, section 2: the force law</source>
            <translation>описание модели, раздел 2: закон силы</translation>
        </message>
        <message>
            <source>model page, section 3: elastic balance</source>
            <translation>описание модели, раздел 3: упругое равновесие</translation>
        </message>
        <message>
            <source>model page, section 4: blank and profile</source>
            <translation>описание модели, раздел 4: заготовка и её профиль</translation>
        </message>
        <message>
            <source>model page, section 5: traverse cycle</source>
            <translation>описание модели, раздел 5: цикл с продольной подачей</translation>
        </message>
        <message>
            <source>model page, section 6: plunge cycle and compliance along the shaft</source>
            <translation>описание модели, раздел 6: врезной цикл и податливость вдоль вала</translation>
        </message>
        <message>
            <source>model page, section 7: control, end of the cycle, accuracy</source>
            <translation>описание модели, раздел 7: управление, конец цикла, точность</translation>
        </message>
        <message>
            <source>model page, section 8: constraints, batch, optimisation</source>
            <translation>описание модели, раздел 8: ограничения, партия, оптимизация</translation>
        </message>
        <message>
            <source>model page, section 9: misprints in the sources</source>
            <translation>описание модели, раздел 9: опечатки в источниках</translation>
        </message>
        <message>
            <source>model page, section 10: published figures</source>
            <translation>описание модели, раздел 10: опубликованные данные</translation>
        </message>
        <message>
            <source>model page, section 11: exact properties</source>
            <translation>описание модели, раздел 11: точные свойства</translation>
        </message>
        <message>
            <source>model page, section 12: several surfaces in one set-up</source>
            <translation>описание модели, раздел 12: несколько поверхностей за один установ</translation>
        </message>
        <message>
            <source>M. K. Alsigar, thesis abstract, Penza, 2021</source>
            <translation>М. К. Альсигар, автореферат кандидатской диссертации, Пенза, 2021</translation>
        </message>
        <message>
            <source>P. P. Pereverzev, doctoral thesis abstract, Chelyabinsk, 1999</source>
            <translation>П. П. Переверзев, автореферат докторской диссертации, Челябинск, 1999</translation>
        </message>
        <message>
            <source>A. V. Akintseva, digital twin of cylindrical grinding, 2020</source>
            <translation>А. В. Акинцева, цифровой двойник круглого шлифования, 2020</translation>
        </message>
        <message>
            <source>S. N. Korchak, force of a single grain</source>
            <translation>С. Н. Корчак, сила резания единичным зерном</translation>
        </message>
        <message>
            <source>ISO 12180-1:2011, cylindricity</source>
            <translation>ISO 12180-1:2011, цилиндричность</translation>
        </message>
        <message>
            <source>ISO 12181-1:2011, roundness</source>
            <translation>ISO 12181-1:2011, круглость</translation>
        </message>
        <message>
            <source>Hashimoto, 2020, contact stiffness of the wheel</source>
            <translation>Хасимото, 2020, контактная жёсткость круга</translation>
        </message>
        <message>
            <source>J. A. Badger, 2010, waviness of ground parts</source>
            <translation>Дж. А. Баджер, 2010, волнистость шлифованных деталей</translation>
        </message>
        <message>
            <source>ISO 286-1:2010, tolerance classes</source>
            <translation>ISO 286-1:2010, квалитеты и поля допусков</translation>
        </message>
        <message>
            <source>ISO 525, marking of grinding wheels</source>
            <translation>ISO 525, маркировка шлифовальных кругов</translation>
        </message>
        <message>
            <source>GOST R 52781, grinding wheels</source>
            <translation>ГОСТ Р 52781, круги шлифовальные</translation>
        </message>
        <message>
            <source>the marking on the wheel itself</source>
            <translation>маркировка на самом круге</translation>
        </message>
        <message>
            <source>Zaporozhabrasive, marking of abrasive tools</source>
            <translation>«Запорожабразив», маркировка абразивного инструмента</translation>
        </message>
        <message>
            <source>aloro.org, steel 40Х</source>
            <translation>aloro.org, сталь 40Х</translation>
        </message>
        <message>
            <source>aloro.org, steel 38ХМА</source>
            <translation>aloro.org, сталь 38ХМА</translation>
        </message>
        <message>
            <source>allmetals.ru, steel 38ХМА</source>
            <translation>allmetals.ru, сталь 38ХМА</translation>
        </message>
        <message>
            <source>altermet.ru, steel 12ХН3А</source>
            <translation>altermet.ru, сталь 12ХН3А</translation>
        </message>
        <message>
            <source>uralprokatmetiz.ru, steel 40</source>
            <translation>uralprokatmetiz.ru, сталь 40</translation>
        </message>
        <message>
            <source>uralprokatmetiz.ru, steel 45</source>
            <translation>uralprokatmetiz.ru, сталь 45</translation>
        </message>
        <message>
            <source>ferrotrade.org, steel ШХ15</source>
            <translation>ferrotrade.org, сталь ШХ15</translation>
        </message>
        <message>
            <source>metall.life, steel 18ХГТ</source>
            <translation>metall.life, сталь 18ХГТ</translation>
        </message>
        <message>
            <source>scraptraffic.com, grey iron СЧ25</source>
            <translation>scraptraffic.com, серый чугун СЧ25</translation>
        </message>
        <message>
            <source>steel-lib, representative values</source>
            <translation>steel-lib, типичные значения</translation>
        </message>
        <message>
            <source>GOST 1412, appendix 2, grey iron</source>
            <translation>ГОСТ 1412, приложение 2, серый чугун</translation>
        </message>
        <message>
            <source>Salmon and others, 2011, random numbers from a counter</source>
            <translation>Salmon и др., 2011, случайные числа по счётчику</translation>
        </message>
        <message>
            <source>Joe and Kuo, 2008, Sobol sequences</source>
            <translation>Joe, Kuo, 2008, последовательности Соболя</translation>
        </message>
        <message>
            <source>McKay, Beckman and Conover, 1979, Latin hypercube</source>
            <translation>McKay, Beckman, Conover, 1979, латинский гиперкуб</translation>
        </message>
        <message>
            <source>Iman and Conover, 1982, rank correlation</source>
            <translation>Iman, Conover, 1982, ранговая корреляция</translation>
        </message>
        <message>
            <source>Iman and Conover, 1979, regression of ranks</source>
            <translation>Iman, Conover, 1979, регрессия рангов</translation>
        </message>
        <message>
            <source>Saltelli and others, 2010, Sobol indices</source>
            <translation>Saltelli и др., 2010, индексы Соболя</translation>
        </message>
        <message>
            <source>Kulisch, 2008, exact sums</source>
            <translation>Kulisch, 2008, точные суммы</translation>
        </message>
        <message>
            <source>Clopper and Pearson, 1934, bounds of a share</source>
            <translation>Clopper, Pearson, 1934, границы доли</translation>
        </message>
        <message>
            <source>Kotz and Johnson, 1993, process capability indices</source>
            <translation>Kotz, Johnson, 1993, показатели пригодности процесса</translation>
        </message>
        <message>
            <source>Bissell, 1990, bounds of Cpk</source>
            <translation>Bissell, 1990, границы Cpk</translation>
        </message>
        <message>
            <source>Gilbert, 1950, economics of machining</source>
            <translation>Гилберт, 1950, экономика обработки резанием</translation>
        </message>
        <message>
            <source>ISO 22514-1, process performance</source>
            <translation>ISO 22514-1, пригодность процесса</translation>
        </message>
        <message>
            <source>Shapiro and Wilk, 1965, test for normality</source>
            <translation>Shapiro, Wilk, 1965, критерий нормальности</translation>
        </message>
        <message>
            <source>Royston, 1995, algorithm AS R94 for W</source>
            <translation>Royston, 1995, алгоритм AS R94 для W</translation>
        </message>
        <message>
            <source>Stephens, 1974, statistics of goodness of fit</source>
            <translation>Stephens, 1974, критерии согласия</translation>
        </message>
        <message>
            <source>D&apos;Agostino and Stephens, 1986, goodness of fit</source>
            <translation>D&apos;Agostino, Stephens, 1986, критерии согласия</translation>
        </message>
        <message>
            <source>Fisher, 1925, test of two variances</source>
            <translation>Фишер, 1925, сравнение двух дисперсий</translation>
        </message>
        <message>
            <source>Welch, 1947, means of unequal variances</source>
            <translation>Уэлч, 1947, средние при неравных дисперсиях</translation>
        </message>
        <message>
            <source>Huber, 1981, robust estimates</source>
            <translation>Хьюбер, 1981, робастные оценки</translation>
        </message>
        <message>
            <source>FIPS 180-4, secure hash standard</source>
            <translation>FIPS 180-4, стандарт безопасного хеширования</translation>
        </message>
        <message>
            <source>sizes of F grits after FEPA 42-D-1986</source>
            <translation>размеры зёрен F по FEPA 42-D-1986</translation>
        </message>
        <message>
            <source>DIN 50150, strength and hardness of steel</source>
            <translation>DIN 50150, прочность и твёрдость стали</translation>
        </message>
        <message>
            <source>SAE J417, strength and hardness of steel</source>
            <translation>SAE J417, прочность и твёрдость стали</translation>
        </message>
        <message>
            <source>Tabor, 1951, yield stress and hardness</source>
            <translation>Тейбор, 1951, предел текучести и твёрдость</translation>
        </message>
        <message>
            <source>Machinery&apos;s Handbook 31, cylindrical grinding</source>
            <translation>Machinery&apos;s Handbook, 31-е изд., круглое шлифование</translation>
        </message>
        <message>
            <source>hon1.ru, spark-out and threshold force</source>
            <translation>hon1.ru, выхаживание и пороговая сила</translation>
        </message>
        <message>
            <source>Akaike, 1974, choice of a model</source>
            <translation>Акаике, 1974, выбор модели</translation>
        </message>
        <message>
            <source>model page, section 16: waves of the wheel</source>
            <translation>страница модели, раздел 16: волны от круга</translation>
        </message>
        <message>
            <source>hon1.ru, balancing of grinding wheels</source>
            <translation>hon1.ru, балансировка шлифовальных кругов</translation>
        </message>
        <message>
            <source>ISO 21940-11:2016, grades of balance</source>
            <translation>ISO 21940-11:2016, классы точности балансировки</translation>
        </message>
    </context>
    <context>
        <name>Struct</name>
        <message>
            <source>Measured Ra</source>
            <translation>Измеренная Ra</translation>
        </message>
        <message>
            <source>Optimisation</source>
            <translation>Оптимизация</translation>
        </message>
        <message>
            <source>Kept run</source>
            <translation>Запомненный расчёт</translation>
        </message>
        <message>
            <source>Project</source>
            <translation>Проект</translation>
        </message>
        <message>
            <source>Stiffness</source>
            <translation>Жёсткость</translation>
        </message>
        <message>
            <source>Wheel contact</source>
            <translation>Контакт круга</translation>
        </message>
        <message>
            <source>Machine ranges</source>
            <translation>Диапазоны станка</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Станок</translation>
        </message>
        <message>
            <source>Stage</source>
            <translation>Ступень</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Цикл</translation>
        </message>
        <message>
            <source>Gauge</source>
            <translation>ПАК</translation>
        </message>
        <message>
            <source>Wheel</source>
            <translation>Круг</translation>
        </message>
        <message>
            <source>Tolerances</source>
            <translation>Допуски</translation>
        </message>
        <message>
            <source>Shaft segment</source>
            <translation>Ступень вала</translation>
        </message>
        <message>
            <source>Steady rest</source>
            <translation>Люнет</translation>
        </message>
        <message>
            <source>Quill</source>
            <translation>Оправка круга</translation>
        </message>
        <message>
            <source>Shaft</source>
            <translation>Вал</translation>
        </message>
        <message>
            <source>Part</source>
            <translation>Деталь</translation>
        </message>
        <message>
            <source>Factor</source>
            <translation>Фактор</translation>
        </message>
        <message>
            <source>Factors</source>
            <translation>Факторы</translation>
        </message>
        <message>
            <source>Batch</source>
            <translation>Партия</translation>
        </message>
        <message>
            <source>Material</source>
            <translation>Материал</translation>
        </message>
        <message>
            <source>Source of a value</source>
            <translation>Источник значения</translation>
        </message>
        <message>
            <source>Heat data</source>
            <translation>Теплофизические данные</translation>
        </message>
        <message>
            <source>Material of the catalogue</source>
            <translation>Материал каталога</translation>
        </message>
        <message>
            <source>Wheel of the catalogue</source>
            <translation>Круг каталога</translation>
        </message>
        <message>
            <source>Machine of the catalogue</source>
            <translation>Станок каталога</translation>
        </message>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>Requirement</source>
            <translation>Требование</translation>
        </message>
        <message>
            <source>Summary</source>
            <translation>Итоги</translation>
        </message>
        <message>
            <source>Varied input</source>
            <translation>Варьируемая величина</translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation>Варьирование</translation>
        </message>
        <message>
            <source>Cost of a part</source>
            <translation>Стоимость детали</translation>
        </message>
        <message>
            <source>Standard times</source>
            <translation>Нормы времени</translation>
        </message>
        <message>
            <source>Wheel wear</source>
            <translation>Износ круга</translation>
        </message>
        <message>
            <source>Gap of the surface</source>
            <translation>Паз поверхности</translation>
        </message>
        <message>
            <source>Measured part</source>
            <translation>Измеренная деталь</translation>
        </message>
        <message>
            <source>Measured trace</source>
            <translation>Измеренная запись</translation>
        </message>
        <message>
            <source>Measured statistics</source>
            <translation>Статистика измерений</translation>
        </message>
        <message>
            <source>Calibration</source>
            <translation>Калибровка</translation>
        </message>
        <message>
            <source>Measurements</source>
            <translation>Измерения</translation>
        </message>
        <message>
            <source>Force by the wheel&apos;s recipe</source>
            <translation>Сила по рецептуре круга</translation>
        </message>
        <message>
            <source>Operation card</source>
            <translation>Операционная карта</translation>
        </message>
        <message>
            <source>Access to an input</source>
            <translation>Доступ к исходной величине</translation>
        </message>
        <message>
            <source>Hint</source>
            <translation>Подсказка</translation>
        </message>
        <message>
            <source>Moment shown</source>
            <translation>Показываемый момент</translation>
        </message>
        <message>
            <source>Step</source>
            <translation>Шаг</translation>
        </message>
        <message>
            <source>Lesson</source>
            <translation>Лабораторная работа</translation>
        </message>
        <message>
            <source>Requirements are met</source>
            <translation>Требования выполнены</translation>
        </message>
        <message>
            <source>Quick enough</source>
            <translation>Время цикла</translation>
        </message>
        <message>
            <source>Figure has a value</source>
            <translation>Показатель равен заданному</translation>
        </message>
        <message>
            <source>Number predicted</source>
            <translation>Прогноз числа</translation>
        </message>
        <message>
            <source>Curve predicted</source>
            <translation>Прогноз кривой</translation>
        </message>
        <message>
            <source>Order predicted</source>
            <translation>Прогноз порядка</translation>
        </message>
        <message>
            <source>Option</source>
            <translation>Ответ</translation>
        </message>
        <message>
            <source>Right options chosen</source>
            <translation>Выбраны верные</translation>
        </message>
        <message>
            <source>Answer in words</source>
            <translation>Ответ словами</translation>
        </message>
        <message>
            <source>Goal</source>
            <translation>Цель</translation>
        </message>
        <message>
            <source>Figure</source>
            <translation>Показатель</translation>
        </message>
        <message>
            <source>Value of an input</source>
            <translation>Значение исходной величины</translation>
        </message>
        <message>
            <source>Text in both languages</source>
            <translation>Текст на двух языках</translation>
        </message>
        <message>
            <source>Control question</source>
            <translation>Контрольный вопрос</translation>
        </message>
        <message>
            <source>Typical mistake</source>
            <translation>Типичная ошибка</translation>
        </message>
        <message>
            <source>Guide for the teacher</source>
            <translation>Указания преподавателю</translation>
        </message>
        <message>
            <source>Hidden parts</source>
            <translation>Что скрыто</translation>
        </message>
        <message>
        <source>Set of values</source>
        <translation>Набор данных</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>Сложность</translation>
    </message>
    <message>
        <source>Bounds of a figure</source>
        <translation>Границы показателя</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Варианты</translation>
    </message>
        <message>
            <source>Machine&apos;s form</source>
            <translation>Форма от станка</translation>
        </message>
        <message>
            <source>Company and signatures</source>
            <translation>Предприятие и подписи</translation>
        </message>
        <message>
            <source>Title page</source>
            <translation>Титульный лист</translation>
        </message>
        <message>
            <source>Wheel runout</source>
            <translation>Биение круга</translation>
        </message>
        <message>
            <source>Variation of the work speed</source>
            <translation>Изменение частоты вращения заготовки</translation>
        </message>
    </context>
    <context>
        <name>StudiesShown</name>
        <message>
            <source>These results are for the inputs before the last edit. Compute them for the current inputs in the view “%1”.</source>
            <translation>Исходные данные изменены. Повторите расчёт в виде «%1».</translation>
        </message>
        <message>
            <source>It is being run: wait for it, or stop it.</source>
            <translation>Расчёт ещё идёт: дождитесь его или остановите.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StudyView</name>
        <message>
            <source>These results are for the inputs before the last edit; those for the current inputs are being computed.</source>
            <translation>Исходные данные изменены; расчёт идёт заново.</translation>
        </message>
        <message>
            <source>These results are for the inputs before the last edit. Press “%1” to compute them for the current inputs.</source>
            <translation>Исходные данные изменены. Нажмите «%1».</translation>
        </message>
    </context>
    <context>
        <name>StudyBook</name>
        <message>
            <source>Quantity</source>
            <translation>Показатель</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Project</source>
            <translation>Проект</translation>
        </message>
        <message>
            <source>Engine</source>
            <translation>Версия расчёта</translation>
        </message>
        <message>
            <source>Parts run</source>
            <translation>Рассчитано деталей</translation>
        </message>
        <message>
            <source>Parts of the batch</source>
            <translation>Деталей в партии</translation>
        </message>
        <message>
            <source>Scenarios</source>
            <translation>Сценарии</translation>
        </message>
        <message>
            <source>Seed</source>
            <translation>Номер выборки</translation>
        </message>
        <message>
            <source>Extent of the run</source>
            <translation>Что рассчитано</translation>
        </message>
        <message>
            <source>Verdict: the cycle</source>
            <translation>Заключение: цикл</translation>
        </message>
        <message>
            <source>Deciding result</source>
            <translation>Чем определено</translation>
        </message>
        <message>
            <source>Rejected parts</source>
            <translation>Негодных деталей</translation>
        </message>
        <message>
            <source>Share of rejected parts</source>
            <translation>Доля негодных деталей</translation>
        </message>
        <message>
            <source>Share of rejected parts, 95 % from</source>
            <translation>Доля негодных, 95 % от</translation>
        </message>
        <message>
            <source>Share of rejected parts, 95 % to</source>
            <translation>Доля негодных, 95 % до</translation>
        </message>
        <message>
            <source>Parts that did not reach size</source>
            <translation>Деталей, не достигших размера</translation>
        </message>
        <message>
            <source>Factor: %1</source>
            <translation>Фактор: %1</translation>
        </message>
        <message>
            <source>Number of the part</source>
            <translation>Номер детали</translation>
        </message>
        <message>
            <source>Factor</source>
            <translation>Фактор</translation>
        </message>
        <message>
            <source>Batch</source>
            <comment>of parts</comment>
            <translation>Партия</translation>
        </message>
        <message>
            <source>Statistics</source>
            <translation>Статистика</translation>
        </message>
        <message>
            <source>Rejects by cause</source>
            <translation>Брак по причинам</translation>
        </message>
        <message>
            <source>Correlation</source>
            <translation>Корреляция</translation>
        </message>
        <message>
            <source>Rank regression</source>
            <translation>Ранговая регрессия</translation>
        </message>
        <message>
            <source>Sobol indices</source>
            <translation>Индексы Соболя</translation>
        </message>
        <message>
            <source>Histograms</source>
            <translation>Гистограммы</translation>
        </message>
        <message>
            <source>Worst part</source>
            <translation>Худшая деталь</translation>
        </message>
        <message>
            <source>Results</source>
            <translation>Результаты</translation>
        </message>
        <message>
            <source>%1: of the project</source>
            <translation>%1: в проекте</translation>
        </message>
        <message>
            <source>%1: from</source>
            <translation>%1: от</translation>
        </message>
        <message>
            <source>%1: to</source>
            <translation>%1: до</translation>
        </message>
        <message>
            <source>%1: values</source>
            <translation>%1: число значений</translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation>Варьирование</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Точки</translation>
        </message>
        <message>
            <source>Time of your cycle</source>
            <translation>Время вашего цикла</translation>
        </message>
        <message>
            <source>Requirement</source>
            <translation>Требование</translation>
        </message>
        <message>
            <source>Binds</source>
            <translation>Ограничивает</translation>
        </message>
        <message>
            <source>Times it cut</source>
            <translation>Сколько раз отсекло</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>да</translation>
        </message>
        <message>
            <source>no</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>Поиск</translation>
        </message>
        <message>
            <source>Settings</source>
            <translation>Настройки</translation>
        </message>
        <message>
            <source>Cycle found</source>
            <translation>Найденный цикл</translation>
        </message>
        <message>
            <source>Best cycles</source>
            <translation>Лучшие циклы</translation>
        </message>
        <message>
            <source>Time by stages</source>
            <translation>Время по числу ступеней</translation>
        </message>
        <message>
            <source>Binding requirements</source>
            <translation>Ограничивающие требования</translation>
        </message>
        <message>
            <source>Factors and verdict, statistics, rejects by cause, influence of the factors, histograms and the worst part, each on a separate sheet.</source>
            <translation>Факторы и заключение, статистика, брак по причинам, влияние факторов, гистограммы и худшая деталь — каждое на отдельном листе.</translation>
        </message>
        <message>
            <source>The inputs varied and every point; over two inputs every quantity on a separate sheet, too.</source>
            <translation>Варьируемые величины и все точки; по двум величинам — ещё и каждый показатель на отдельном листе.</translation>
        </message>
        <message>
            <source>not known, it was stopped</source>
            <translation>неизвестно: поиск остановлен</translation>
        </message>
        <message>
            <source>Margin by time</source>
            <translation>Запас по времени</translation>
        </message>
        <message>
            <source>The answer, the settings, the cycle found, the best cycles, the time by stages, the margin by time and the binding requirements, each on a separate sheet.</source>
            <translation>Ответ, настройки, найденный цикл, лучшие циклы, время по числу ступеней, запас по времени и ограничивающие требования — каждое на отдельном листе.</translation>
        </message>
        <message>
            <source>Notes</source>
            <translation>Примечания</translation>
        </message>
        <message>
            <source>Answer</source>
            <translation>Ответ</translation>
        </message>
    </context>
    <context>
        <name>PhaseText</name>
        <message>
            <source>Rejected by stock alone: %1.</source>
            <translation>Деталей партии, не годных из-за припуска: %1.</translation>
        </message>
        <message>
            <source>The stock of %1 lies outside the range.</source>
            <translation>У %1 припуск вне диапазона.</translation>
        </message>
        <message>
            <source>The stocks are being checked</source>
            <translation>Проверяются припуски диапазона</translation>
        </message>
        <message>
            <source>Pieces: %1</source>
            <translation>Участков: %1</translation>
        </message>
        <message>
            <source>Under position control the stocks within one infeed cannot be decided: the wheel touches the part at an unknown point within the first infeed. Vary the stock in a sweep, or let it scatter in a batch.</source>
            <translation>При управлении по положению проверить все припуски нельзя: первый шаг встречает деталь где-то в пределах подачи на шаг. Варьируйте припуск или задайте его рассеяние в партии.</translation>
        </message>
        <message>
            <source>The cycle is fit for every stock per side from %1 to %2 mm.</source>
            <translation>Годен при любом припуске на сторону от %1 до %2 мм.</translation>
        </message>
        <message>
            <source>from %1 to %2</source>
            <translation>от %1 до %2</translation>
        </message>
        <message>
            <source>The cycle is unfit for stocks per side %1 mm%2: %3.</source>
            <translation>Не годен при припусках на сторону %1 мм%2: %3.</translation>
        </message>
        <message>
            <source> (further ranges: %1)</source>
            <translation> (ещё диапазонов: %1)</translation>
        </message>
        <message>
            <source>With other stocks, other requirements are not met: see the table of the plot.</source>
            <translation>При других припусках нарушены другие требования: см. таблицу графика.</translation>
        </message>
        <message>
            <source>fit</source>
            <translation>годен</translation>
        </message>
        <message>
            <source>fit from %1 to %2 mm, otherwise unfit: %3</source>
            <translation>годен от %1 до %2 мм, иначе нет: %3</translation>
        </message>
        <message>
            <source>unfit: %1</source>
            <translation>не годен: %1</translation>
        </message>
        <message>
            <source>Stock %1 mm: steps %2, %3</source>
            <translation>Припуск %1 мм: шагов %2, %3</translation>
        </message>
        <message>
            <source>, diameters %1…%2 µm from nominal</source>
            <translation>, диаметры %1…%2 мкм от номинала</translation>
        </message>
        <message>
            <source>all requirements are met</source>
            <translation>выполнены все требования</translation>
        </message>
        <message>
            <source>The range has more than %1 pieces: enter a narrower range.</source>
            <translation>В диапазоне больше %1 участков: задайте более узкий.</translation>
        </message>
    </context>
    <context>
        <name>SweepText</name>
        <message>
            <source>Machining time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>Minimum margin of all requirements</source>
            <translation>Наименьший запас по всем требованиям</translation>
        </message>
        <message>
            <source>Mean diameter</source>
            <translation>Средний диаметр</translation>
        </message>
        <message>
            <source>Maximum normal force</source>
            <translation>Наибольшая нормальная сила</translation>
        </message>
        <message>
            <source>Maximum power</source>
            <translation>Наибольшая мощность</translation>
        </message>
        <message>
            <source>whole part</source>
            <translation>вся деталь</translation>
        </message>
        <message>
            <source>Margin: %1</source>
            <translation>Запас: %1</translation>
        </message>
        <message>
            <source>not run</source>
            <translation>не рассчитано</translation>
        </message>
        <message>
            <source>refused</source>
            <translation>отклонено</translation>
        </message>
        <message>
            <source>does not reach size</source>
            <translation>размер не достигается</translation>
        </message>
        <message>
            <source>fit</source>
            <translation>годен</translation>
        </message>
        <message>
            <source>unfit</source>
            <translation>не выполнено</translation>
        </message>
        <message>
            <source>%1 of %2 points</source>
            <translation>%1 из %2 точек</translation>
        </message>
        <message>
            <source>Stopped after %1 of %2 points.</source>
            <translation>Остановлено: сделано %1 из %2 точек.</translation>
        </message>
        <message>
            <source>%1 of %2 points meet the drawing.</source>
            <translation>Чертёж выдержан в точках: %1 из %2.</translation>
        </message>
        <message>
            <source>Refused: %1.</source>
            <translation>Отклонено: %1.</translation>
        </message>
        <message>
            <source>Size not reached: %1.</source>
            <translation>Размер не достигнут: %1.</translation>
        </message>
        <message>
            <source>all requirements are met</source>
            <translation>выполнены все требования</translation>
        </message>
        <message>
            <source>not met: %1</source>
            <translation>не выполнено: %1</translation>
        </message>
        <message>
            <source>%1: not run</source>
            <translation>%1: не рассчитано</translation>
        </message>
        <message>
            <source>%1: refused. %2</source>
            <translation>%1: отклонено. %2</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source> (margin %1)</source>
            <translation> (запас %1)</translation>
        </message>
        <message>
            <source> time %1;</source>
            <translation> время %1;</translation>
        </message>
    </context>
    <context>
        <name>Symbol</name>
        <message>
            <source>equivalent diameter of wheel and part</source>
            <translation>эквивалентный диаметр круга и детали</translation>
        </message>
        <message>
            <source>surface speed of the part</source>
            <translation>окружная скорость заготовки</translation>
        </message>
        <message>
            <source>normal force of shear, per width and depth</source>
            <translation>нормальная сила сдвига на единицу ширины и подачи</translation>
        </message>
        <message>
            <source>normal force of the wear flats, per width and root of the depth</source>
            <translation>нормальная сила площадок износа на единицу ширины и корня из подачи</translation>
        </message>
        <message>
            <source>tangential force of shear, per width and depth</source>
            <translation>касательная сила сдвига на единицу ширины и подачи</translation>
        </message>
        <message>
            <source>normal force</source>
            <translation>нормальная сила</translation>
        </message>
        <message>
            <source>tangential force</source>
            <translation>касательная составляющая силы резания</translation>
        </message>
        <message>
            <source>limiting depth of cut</source>
            <translation>предельная фактическая подача</translation>
        </message>
        <message>
            <source>actual feed: the depth of this cut</source>
            <translation>фактическая подача: глубина этого среза</translation>
        </message>
        <message>
            <source>effective width of cut</source>
            <translation>эффективная ширина резания</translation>
        </message>
        <message>
            <source>accumulated programmed feed, from the first touch on</source>
            <translation>накопленная программная подача от первого касания</translation>
        </message>
        <message>
            <source>maximum radius of the blank</source>
            <translation>наибольший радиус заготовки</translation>
        </message>
        <message>
            <source>minimum radius of the blank</source>
            <translation>наименьший радиус заготовки</translation>
        </message>
        <message>
            <source>radius k before the cut</source>
            <translation>радиус k до среза</translation>
        </message>
        <message>
            <source>radius k after the cut</source>
            <translation>радиус k после среза</translation>
        </message>
        <message>
            <source>target radius</source>
            <translation>целевой радиус</translation>
        </message>
        <message>
            <source>stock left at radius k</source>
            <translation>оставшийся припуск на радиусе k</translation>
        </message>
        <message>
            <source>stock left below the cut</source>
            <translation>припуск, оставшийся под срезом</translation>
        </message>
        <message>
            <source>lag of the radius: the distance of the wheel head ahead of it</source>
            <translation>отставание радиуса: насколько шлифовальная бабка подана дальше него</translation>
        </message>
        <message>
            <source>compliance of the system</source>
            <translation>податливость технологической системы</translation>
        </message>
        <message>
            <source>lag per depth of cut, without the wear flats</source>
            <translation>отставание на единицу подачи без площадок износа</translation>
        </message>
        <message>
            <source>deflection by the wear flats, per root of the depth</source>
            <translation>отжатие от площадок износа на единицу корня из подачи</translation>
        </message>
        <message>
            <source>root of the depth of cut</source>
            <translation>корень из фактической подачи</translation>
        </message>
        <message>
            <source>deflection of the system</source>
            <translation>упругое отжатие системы</translation>
        </message>
        <message>
            <source>total deflection</source>
            <translation>отжатие всего, что податливо</translation>
        </message>
        <message>
            <source>allowed temperature rise of the surface</source>
            <translation>предельно допустимый нагрев поверхности</translation>
        </message>
        <message>
            <source>depth that the heat reaches during the contact</source>
            <translation>глубина прогрева за время контакта</translation>
        </message>
        <message>
            <source>stock left over twice this depth</source>
            <translation>этот припуск, делённый на две таких глубины</translation>
        </message>
        <message>
            <source>temperature rise per force, from the heat conduction</source>
            <translation>нагрев на единицу силы, из теплопроводности</translation>
        </message>
        <message>
            <source>coefficient of the cubic equation w³ + p·w = Q</source>
            <translation>коэффициент кубического уравнения w³ + p·w = Q</translation>
        </message>
        <message>
            <source>right side of that equation</source>
            <translation>правая часть этого уравнения</translation>
        </message>
        <message>
            <source>Cardano&apos;s root on the way to w</source>
            <translation>корень Кардано на пути к w</translation>
        </message>
        <message>
            <source>fourth root of the depth of cut</source>
            <translation>корень четвёртой степени из фактической подачи</translation>
        </message>
        <message>
            <source>structure number of the wheel</source>
            <translation>номер структуры круга</translation>
        </message>
        <message>
            <source>profile of the dressed grains</source>
            <translation>профиль правленых зёрен</translation>
        </message>
        <message>
            <source>opening of the wheel&apos;s profile by the cut</source>
            <translation>раскрытие профиля круга при срезе</translation>
        </message>
        <message>
            <source>share of the profile removed by the cut</source>
            <translation>доля профиля, занятая срезом</translation>
        </message>
        <message>
            <source>overlap: revolutions over a point in a stroke</source>
            <translation>коэффициент перекрытия: оборотов над точкой за ход</translation>
        </message>
        <message>
            <source>calibration of Ra: measured over computed</source>
            <translation>поправка Ra: измеренная к вычисленной</translation>
        </message>
        <message>
            <source>limiting actual feed</source>
            <translation>предельная скорость фактической подачи</translation>
        </message>
        <message>
            <source>section of a bond bridge</source>
            <translation>сечение мостика связки</translation>
        </message>
        <message>
            <source>diameter of a bond bridge</source>
            <translation>диаметр мостика связки</translation>
        </message>
        <message>
            <source>grains on a square millimetre of the wheel</source>
            <translation>число зёрен на квадратном миллиметре круга</translation>
        </message>
        <message>
            <source>force that breaks a grain</source>
            <translation>сила, разрушающая зерно</translation>
        </message>
        <message>
            <source>force that breaks its bond</source>
            <translation>сила, разрушающая его связку</translation>
        </message>
        <message>
            <source>critical force of one grain</source>
            <translation>критическая сила на одно зерно</translation>
        </message>
        <message>
            <source>force that the wheel withstands, per width and root of the depth</source>
            <translation>сила, которую выдерживает круг, на единицу ширины и корня из подачи</translation>
        </message>
        <message>
            <source>tangential force that the drive allows, per width</source>
            <translation>касательная сила, которую допускает привод, на единицу ширины</translation>
        </message>
        <message>
            <source>cutting grains on a square millimetre of the contact</source>
            <translation>режущих зёрен на квадратном миллиметре контакта</translation>
        </message>
        <message>
            <source>width of the cut of one grain</source>
            <translation>ширина среза одним зерном</translation>
        </message>
        <message>
            <source>chips of the grains over the metal removed</source>
            <translation>отношение срезов зёрен к снятому металлу</translation>
        </message>
        <message>
            <source>dullness: share of wear flats</source>
            <translation>затупление: доля площадок износа</translation>
        </message>
        <message>
            <source>the sources&apos; name of b·k_s with axial feed</source>
            <translation>b·k_s с продольной подачей, как в источниках</translation>
        </message>
        <message>
            <source>the sources&apos; name of b·k_r with axial feed</source>
            <translation>b·k_r с продольной подачей, как в источниках</translation>
        </message>
        <message>
            <source>the sources&apos; name of b·k_s in plunge</source>
            <translation>b·k_s при врезании, как в источниках</translation>
        </message>
        <message>
            <source>the sources&apos; name of b·k_r in plunge</source>
            <translation>b·k_r при врезании, как в источниках</translation>
        </message>
        <message>
            <source>normal force beyond the threshold, per width and depth</source>
            <translation>нормальная сила сверх пороговой на единицу ширины и глубины</translation>
        </message>
        <message>
            <source>tangential force per area of chip</source>
            <translation>касательная сила на единицу площади среза</translation>
        </message>
        <message>
            <source>tangential force beyond friction, per width and depth</source>
            <translation>касательная сила сверх трения на единицу ширины и глубины</translation>
        </message>
        <message>
            <source>lag up to which the wheel only rubs</source>
            <translation>отставание, до которого круг только трёт</translation>
        </message>
    </context>
    <context>
        <name>TableFile</name>
        <message>
            <source>Too many rows</source>
            <translation>Слишком много строк</translation>
        </message>
        <message>
            <source>“%1” would have %2 rows; a worksheet has at most %3, including the head. It can be saved in full as CSV.</source>
            <translation>На листе «%1» было бы %2 строк, а лист книги вмещает %3 вместе с шапкой. В формате CSV таблицу можно сохранить целиком.</translation>
        </message>
        <message>
            <source>&amp;XLSX workbook…</source>
            <translation>Книга &amp;XLSX…</translation>
        </message>
        <message>
            <source>&amp;Russian Excel: semicolons, decimal commas…</source>
            <translation>&amp;Русский Excel: точка с запятой, десятичная запятая…</translation>
        </message>
        <message>
            <source>&amp;English: commas, decimal points…</source>
            <translation>&amp;Английский: запятая, десятичная точка…</translation>
        </message>
        <message>
            <source>Numbers with all their digits, units in a separate row</source>
            <translation>Числа со всеми знаками, единицы в отдельной строке</translation>
        </message>
        <message>
            <source>Headers in the language of the window; Excel opens the file directly</source>
            <translation>Заголовки на языке окна; Excel открывает файл сразу</translation>
        </message>
        <message>
            <source>XLSX workbooks (*.xlsx)</source>
            <translation>Книги XLSX (*.xlsx)</translation>
        </message>
        <message>
            <source>CSV tables: semicolons, decimal commas, UTF-8 (*.csv)</source>
            <translation>Таблицы CSV: точка с запятой, десятичная запятая, UTF-8 (*.csv)</translation>
        </message>
        <message>
            <source>CSV tables: commas, decimal points, UTF-8 (*.csv)</source>
            <translation>Таблицы CSV: запятая, десятичная точка, UTF-8 (*.csv)</translation>
        </message>
        <message>
            <source>Save the data</source>
            <translation>Сохранить данные</translation>
        </message>
    </context>
    <context>
        <name>Tour</name>
        <message>
            <source>An example to begin with</source>
            <translation>Пример для начала</translation>
        </message>
        <message>
            <source>The stages of the cycle</source>
            <translation>Ступени цикла</translation>
        </message>
        <message>
            <source>Programmed feed and actual cut</source>
            <translation>Программная подача и снятый слой</translation>
        </message>
        <message>
            <source>Does it meet the drawing?</source>
            <translation>Выполнен ли чертёж?</translation>
        </message>
        <message>
            <source>Time of the cycle and every requirement with its margin. A click on a row leads to the place where the value arises.</source>
            <translation>Время цикла и каждое требование с запасом. Щелчок по строке ведёт туда, где значение возникает.</translation>
        </message>
        <message>
            <source>Play with the feeds</source>
            <translation>Поиграйте подачами</translation>
        </message>
        <message>
            <source>Drag a slider and watch curves, time and margins follow. Undo reverts a whole drag.</source>
            <translation>Потяните ползунок и смотрите, как меняются кривые, время и запасы. Отмена возвращает перетаскивание целиком.</translation>
        </message>
        <message>
            <source>Step through the cycle</source>
            <translation>Пройдите цикл по шагам</translation>
        </message>
        <message>
            <source>Play, or step by stage, double stroke, step E1…E5 or radius. All views follow; the button at the right shows the formulas with their numbers.</source>
            <translation>Пустите показ или шагайте по ступеням, двойным ходам, этапам Э1…Э5 или радиусам. За показом следуют все виды; кнопка справа открывает формулы с числами.</translation>
        </message>
        <message>
            <source>Help</source>
            <translation>Справка</translation>
        </message>
        <message>
            <source>F1 explains the field or the view in focus. This tour can be started again from the menu Help.</source>
            <translation>F1 поясняет поле или вид, где стоит курсор. Это знакомство можно повторить из меню «Справка».</translation>
        </message>
        <message>
            <source>A row is a stage: feeds, stock, spark-out, and the time it takes. Type into a cell; everything is computed again at once. The pages above hold part, material, wheel, machine, gauge and batch.</source>
            <translation>Строка — ступень: подачи, припуск, выхаживание и время, которое она занимает. Введите число в ячейку — всё сразу пересчитается. На страницах выше — деталь, материал, круг, станок, ПАК и партия.</translation>
        </message>
        <message>
            <source>Dashed: the feed of the program. Solid: the actual cut, zone by zone, which differs because everything yields. The first tab sums the cycle up in bars; the others show form, limits, compliance, layers, a batch and compared runs.</source>
            <translation>Штриховая линия — подача по программе. Сплошная — то, что на деле достаётся детали, по зонам: ведь всё отжимается. Первая вкладка подводит итог цикла столбцами; на остальных — форма, пределы, податливость, слои, партия и сравнение расчётов.</translation>
        </message>
        <message>
            <source>The last button of the tool bar opens the shipped examples, each as a copy: change what you like. The first one begins a project of your own.</source>
            <translation>Последняя кнопка панели инструментов открывает примеры из поставки, каждый копией: меняйте что угодно. Первая начинает ваш собственный проект.</translation>
        </message>
    </context>
    <context>
        <name>TraceSheet</name>
        <message>
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>Double stroke</source>
            <translation>Двойной ход</translation>
        </message>
        <message>
            <source>Revolution</source>
            <translation>Оборот</translation>
        </message>
        <message>
            <source>Stage</source>
            <translation>Ступень</translation>
        </message>
        <message>
            <source>Zone</source>
            <translation>Зона</translation>
        </message>
        <message>
            <source>Section</source>
            <translation>Сечение</translation>
        </message>
        <message>
            <source>Step</source>
            <translation>Этап</translation>
        </message>
        <message>
            <source>Pass of the step</source>
            <translation>Проход этапа</translation>
        </message>
        <message>
            <source>Radius no.</source>
            <translation>Радиус №</translation>
        </message>
        <message>
            <source>Programmed feed</source>
            <translation>Программная подача</translation>
        </message>
        <message>
            <source>Actual feed</source>
            <translation>Фактическая подача</translation>
        </message>
        <message>
            <source>Accumulated actual feed</source>
            <translation>Накопленная фактическая подача</translation>
        </message>
        <message>
            <source>Radius from nominal</source>
            <translation>Радиус от номинала</translation>
        </message>
        <message>
            <source>Normal force</source>
            <translation>Нормальная сила</translation>
        </message>
        <message>
            <source>Trace %1</source>
            <translation>Трасса %1</translation>
        </message>
    </context>
    <context>
        <name>Unit</name>
        <message>
            <source>mm/min</source>
            <translation>мм/мин</translation>
        </message>
        <message>
            <source>mm/N</source>
            <translation>мм/Н</translation>
        </message>
        <message>
            <source>mm²/s</source>
            <translation>мм²/с</translation>
        </message>
        <message>
            <source>mm</source>
            <translation>мм</translation>
        </message>
        <message>
            <source>µm</source>
            <translation>мкм</translation>
        </message>
        <message>
            <source>rev/min</source>
            <translation>об/мин</translation>
        </message>
        <message>
            <source>m/s</source>
            <translation>м/с</translation>
        </message>
        <message>
            <source>s</source>
            <translation>с</translation>
        </message>
        <message>
            <source>N, N/µm</source>
            <translation>Н, Н/мкм</translation>
        </message>
        <message>
            <source>N/µm</source>
            <translation>Н/мкм</translation>
        </message>
        <message>
            <source>MPa</source>
            <translation>МПа</translation>
        </message>
        <message>
            <source>GPa</source>
            <translation>ГПа</translation>
        </message>
        <message>
            <source>kW</source>
            <translation>кВт</translation>
        </message>
        <message>
            <source>HRC</source>
            <translation>HRC</translation>
        </message>
        <message>
            <source>W/(m·K)</source>
            <translation>Вт/(м·К)</translation>
        </message>
        <message>
            <source>J/m²</source>
            <translation>Дж/м²</translation>
        </message>
        <message>
            <source>1/mm²</source>
            <translation>1/мм²</translation>
        </message>
        <message>
            <source>K</source>
            <translation>К</translation>
        </message>
        <message>
            <source>10⁻⁶/K</source>
            <translation>10⁻⁶/К</translation>
        </message>
        <message>
            <source>µm/h</source>
            <translation>мкм/ч</translation>
        </message>
        <message>
            <source>h</source>
            <translation>ч</translation>
        </message>
        <message>
            <source>°</source>
            <translation>°</translation>
        </message>
        <message>
            <source>bytes</source>
            <translation>байт</translation>
        </message>
        <message>
            <source>tags</source>
            <translation>тегов</translation>
        </message>
        <message>
            <source>nested tags</source>
            <translation>вложенных тегов</translation>
        </message>
        <message>
            <source>N</source>
            <translation>Н</translation>
        </message>
        <message>
            <source>N/mm</source>
            <translation>Н/мм</translation>
        </message>
        <message>
            <source>N/mm^1.5</source>
            <translation>Н/мм^1,5</translation>
        </message>
        <message>
            <source>K·mm^1.25/N</source>
            <translation>К·мм^1,25/Н</translation>
        </message>
        <message>
            <source>mW</source>
            <translation>мВт</translation>
        </message>
        <message>
            <source>mW/mm²</source>
            <translation>мВт/мм²</translation>
        </message>
        <message>
            <source>mm/s</source>
            <translation>мм/с</translation>
        </message>
        <message>
            <source>mm²</source>
            <translation>мм²</translation>
        </message>
        <message>
            <source>mm^0.25</source>
            <translation>мм^0,25</translation>
        </message>
        <message>
            <source>mm^0.5</source>
            <translation>мм^0,5</translation>
        </message>
        <message>
            <source>mm^0.75</source>
            <translation>мм^0,75</translation>
        </message>
        <message>
            <source>mm^1.5</source>
            <translation>мм^1,5</translation>
        </message>
        <message>
            <source>mm/dbl stroke</source>
            <translation>мм/дв. ход</translation>
        </message>
        <message>
            <source>min</source>
            <translation>мин</translation>
        </message>
        <message>
            <source>W</source>
            <translation>Вт</translation>
        </message>
        <message>
            <source>%</source>
            <translation>%</translation>
        </message>
        <message>
            <source>nm/N</source>
            <translation>нм/Н</translation>
        </message>
        <message>
            <source>mm³</source>
            <translation>мм³</translation>
        </message>
        <message>
            <source>kJ</source>
            <translation>кДж</translation>
        </message>
        <message>
            <source>J/mm³</source>
            <translation>Дж/мм³</translation>
        </message>
        <message>
            <source>mm³/(mm·s)</source>
            <translation>мм³/(мм·с)</translation>
        </message>
        <message>
            <source>m/min</source>
            <translation>м/мин</translation>
        </message>
        <message>
            <source>1/h</source>
            <translation>1/ч</translation>
        </message>
        <message>
            <source>°C</source>
            <translation>°C</translation>
        </message>
        <message>
            <source>kg/m³</source>
            <translation>кг/м³</translation>
        </message>
        <message>
            <source>°C, W/(m·K)</source>
            <translation>°C, Вт/(м·К)</translation>
        </message>
        <message>
            <source>°C, J/(kg·K)</source>
            <translation>°C, Дж/(кг·К)</translation>
        </message>
        <message>
            <source>kW/A</source>
            <translation>кВт/А</translation>
        </message>
        <message>
            <source>N/mm^0.5</source>
            <translation>Н/мм^0,5</translation>
        </message>
        <message>
            <source>kg</source>
            <translation>кг</translation>
        </message>
        <message>
            <source>1/mm</source>
            <translation>1/мм</translation>
        </message>
        <message>
            <source>N/mm²</source>
            <translation>Н/мм²</translation>
        </message>
        <message>
            <source>points</source>
            <translation>балл.</translation>
        </message>
        <message>
            <source>g·mm</source>
            <translation>г·мм</translation>
        </message>
        <message>
            <source>Hz</source>
            <translation>Гц</translation>
        </message>
    </context>
    <context>
        <name>VerdictText</name>
        <message>
            <source>%1 min</source>
            <translation>%1 мин</translation>
        </message>
        <message>
            <source>%1 (%2 s)</source>
            <translation>%1 (%2 с)</translation>
        </message>
        <message>
            <source>%1: the gauge reads %2 mm, %3 µm per side remain</source>
            <translation>%1: показание прибора %2 мм, осталось %3 мкм на сторону</translation>
        </message>
        <message>
            <source>%1 s (%2)</source>
            <translation>%1 с (%2)</translation>
        </message>
    </context>
    <context>
        <name>VerdictWhy</name>
        <message>
            <source>%1: not known, since strips stay uncut; an axial feed of at most %2 mm/min leaves none.</source>
            <translation>%1: неизвестно, так как остаются непрошлифованные полосы; при продольной подаче не более %2 мм/мин их нет.</translation>
        </message>
        <message>
            <source>The wheel&apos;s width times the work speed over the axial feed; 1 is reached at %1 mm/min.</source>
            <translation>Высота круга, умноженная на частоту вращения заготовки и делённая на продольную подачу; значение 1 достигается при %1 мм/мин.</translation>
        </message>
        <message>
            <source>The wheel&apos;s width times the work speed over the axial feed; %1 is reached at %2 mm/min.</source>
            <translation>Высота круга, умноженная на частоту вращения заготовки и делённая на продольную подачу; значение %1 достигается при %2 мм/мин.</translation>
        </message>
        <message>
            <source>This is the minimum over the stages with stock; a smaller feed or more stock in stage %1 increases it.</source>
            <translation>Наименьшее число среди ступеней с припуском; меньшая подача или больший припуск ступени %1 увеличит его.</translation>
        </message>
        <message>
            <source>%1 against the gauge %2 µm</source>
            <comment>zone</comment>
            <translation>%1 относительно прибора %2 мкм</translation>
        </message>
        <message>
            <source> (compliance %1 of the gauged one&apos;s)</source>
            <translation> (податливость %1 от той, где прибор)</translation>
        </message>
        <message>
            <source>gauge at the end %1 µm</source>
            <translation>прибор в конце %1 мкм</translation>
        </message>
        <message>
            <source>spread in the section %1 µm</source>
            <translation>непостоянство диаметра в сечении %1 мкм</translation>
        </message>
        <message>
            <source>%1 in %2, %3 µm from nominal: %4.</source>
            <translation>%1 (%2), %3 мкм от номинала: %4.</translation>
        </message>
        <message>
            <source>; the machine&apos;s own runout adds %1 µm</source>
            <translation>; биение станка добавляет %1 мкм</translation>
        </message>
        <message>
            <source>, more than the limit: no cycle can meet it.</source>
            <translation>, больше предела: никакой цикл его не выдержит.</translation>
        </message>
        <message>
            <source>. More passes without feed or a smaller last feed reduce it.</source>
            <translation>. Уменьшат его выхаживание подольше или меньшая последняя подача.</translation>
        </message>
        <message>
            <source>Mean radii along the part, µm from their own mean: %1; the worst section is %2 µm out of round.</source>
            <translation>Средние радиусы вдоль детали, мкм от их общего среднего: %1; худшее сечение некруглое на %2 мкм.</translation>
        </message>
        <message>
            <source>%1: left by the last cut (%2).</source>
            <translation>%1: след последнего съёма (%2).</translation>
        </message>
        <message>
            <source>%1: worst in %2.</source>
            <translation>%1: хуже всего здесь: %2.</translation>
        </message>
        <message>
            <source> A smaller feed in stage %1 or a sharper wheel lowers it.</source>
            <translation> Снизят её меньшая подача ступени %1 или более острый круг.</translation>
        </message>
        <message>
            <source>%1 in %2: the blank has %3 µm, the end of the cycle %4 µm</source>
            <translation>%1 (%2): у заготовки %3 мкм, в конце цикла %4 мкм</translation>
        </message>
        <message>
            <source> With an even number of lobes: %1 µm.</source>
            <translation> При чётном числе граней: %1 мкм.</translation>
        </message>
        <message>
            <source>; the machine&apos;s share is not known</source>
            <translation>; без погрешности станка</translation>
        </message>
        <message>
            <source>, including the form that the machine prints</source>
            <translation>, с формой от станка</translation>
        </message>
        <message>
            <source>The runout of the wheel is not given, so the waves it prints are not known.</source>
            <translation>Биение круга не задано, поэтому волны от него не известны.</translation>
        </message>
        <message>
            <source>A wheel with an amplitude of %1 µm prints %2 waves around the part. A work speed at which the ratio of the speeds is not near to a whole number leaves less of them.</source>
            <translation>От круга с амплитудой биения %1 мкм на детали %2 волн по окружности. При частоте вращения заготовки, для которой отношение частот не близко к целому, их остаётся меньше.</translation>
        </message>
    </context>
    <context>
        <name>WatchDialog</name>
        <message>
            <source>Progress</source>
            <translation>Ход расчёта</translation>
        </message>
        <message>
            <source>&amp;Stop</source>
            <translation>&amp;Остановить</translation>
        </message>
    </context>
    <context>
        <name>Zone</name>
        <message>
            <source>RZ1</source>
            <translation>РЗ1</translation>
        </message>
        <message>
            <source>NZ</source>
            <translation>НЗ</translation>
        </message>
        <message>
            <source>RZ2</source>
            <translation>РЗ2</translation>
        </message>
        <message>
            <source>Section %1</source>
            <translation>Сечение %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::AboutDialog</name>
        <message>
            <source>About Sparkout</source>
            <translation>О программе Sparkout</translation>
        </message>
        <message>
            <source>Icon of the program</source>
            <translation>Значок программы</translation>
        </message>
        <message>
            <source>Sparkout %1</source>
            <translation>Sparkout %1</translation>
        </message>
        <message>
            <source>A workbench for cylindrical grinding cycles: it computes a cycle pass by pass and checks it against the drawing.</source>
            <translation>Рабочее место технолога круглого шлифования: рассчитывает цикл проход за проходом и сравнивает результат с чертежом.</translation>
        </message>
        <message>
            <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
            <translation>Свободная программа под лицензией GNU General Public License версии 3 или новее. Без каких-либо гарантий.</translation>
        </message>
        <message>
            <source>C&amp;lose</source>
            <translation>&amp;Закрыть</translation>
        </message>
        <message>
            <source>C&amp;opy the versions</source>
            <translation>&amp;Копировать версии</translation>
        </message>
        <message>
            <source>Program and engine: %1</source>
            <translation>Программа и расчётное ядро: %1</translation>
        </message>
        <message>
            <source>Vector unit of the processor in use: %1</source>
            <translation>Используемый векторный блок процессора: %1</translation>
        </message>
        <message>
            <source>Qt: %1, built with %2</source>
            <translation>Qt: %1, сборка с %2</translation>
        </message>
        <message>
            <source>Libraries: %1</source>
            <translation>Библиотеки: %1</translation>
        </message>
        <message>
            <source>Compiler: %1</source>
            <translation>Компилятор: %1</translation>
        </message>
        <message>
            <source>System: %1, %2</source>
            <translation>Система: %1, %2</translation>
        </message>
        <message>
            <source>&amp;Licences…</source>
            <translation>&amp;Лицензии…</translation>
        </message>
    </context>
    <context>
        <name>sparkout::Actions</name>
        <message>
            <source>Stoc&amp;k on diameter</source>
            <translation>&amp;Припуск на диаметр</translation>
        </message>
        <message>
            <source>Keep run</source>
            <translation>Запомнить расчёт</translation>
        </message>
        <message>
            <source>Cycle card</source>
            <translation>Карта цикла</translation>
        </message>
        <message>
            <source>Examples</source>
            <translation>Примеры</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>&amp;Отменить</translation>
        </message>
        <message>
            <source>&amp;Undo: %1</source>
            <translation>&amp;Отменить: %1</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>&amp;Повторить</translation>
        </message>
        <message>
            <source>&amp;Redo: %1</source>
            <translation>&amp;Повторить: %1</translation>
        </message>
        <message>
            <source>Undo</source>
            <translation>Отменить</translation>
        </message>
        <message>
            <source>Redo</source>
            <translation>Повторить</translation>
        </message>
        <message>
            <source>&amp;File</source>
            <translation>&amp;Файл</translation>
        </message>
        <message>
            <source>&amp;Edit</source>
            <translation>&amp;Правка</translation>
        </message>
        <message>
            <source>&amp;View</source>
            <translation>&amp;Вид</translation>
        </message>
        <message>
            <source>&amp;Help</source>
            <translation>&amp;Справка</translation>
        </message>
        <message>
            <source>&amp;New</source>
            <translation>&amp;Создать</translation>
        </message>
        <message>
            <source>New project</source>
            <translation>Новый проект</translation>
        </message>
        <message>
            <source>&amp;Language</source>
            <translation>&amp;Язык</translation>
        </message>
        <message>
            <source>Tool bar</source>
            <translation>Панель инструментов</translation>
        </message>
        <message>
            <source>&amp;Traverse grinding</source>
            <translation>Шлифование с пр&amp;одольной подачей</translation>
        </message>
        <message>
            <source>&amp;Plunge grinding</source>
            <translation>&amp;Врезное шлифование</translation>
        </message>
        <message>
            <source>&amp;Open…</source>
            <translation>&amp;Открыть…</translation>
        </message>
        <message>
            <source>&amp;Example gallery…</source>
            <translation>&amp;Примеры…</translation>
        </message>
        <message>
            <source>&amp;Save</source>
            <translation>&amp;Сохранить</translation>
        </message>
        <message>
            <source>Save &amp;as…</source>
            <translation>Сохранить &amp;как…</translation>
        </message>
        <message>
            <source>&amp;Quit</source>
            <translation>В&amp;ыход</translation>
        </message>
        <message>
            <source>&amp;Reset the layout</source>
            <translation>&amp;Вернуть расположение окон</translation>
        </message>
        <message>
            <source>&amp;About Sparkout</source>
            <translation>&amp;О программе Sparkout</translation>
        </message>
        <message>
            <source>invalid entry</source>
            <translation>непринятый текст</translation>
        </message>
        <message>
            <source>&amp;Theme</source>
            <translation>&amp;Тема</translation>
        </message>
        <message>
            <source>&amp;Show a view</source>
            <translation>&amp;Показать вид</translation>
        </message>
        <message>
            <source>Earlier &amp;versions…</source>
            <translation>&amp;Прежние версии…</translation>
        </message>
        <message>
            <source>Re&amp;cover work…</source>
            <translation>Восс&amp;тановить работу…</translation>
        </message>
        <message>
            <source>&amp;Detach or attach the view</source>
            <translation>&amp;Отделить или вернуть вид</translation>
        </message>
        <message>
            <source>&amp;Next panel</source>
            <translation>С&amp;ледующая панель</translation>
        </message>
        <message>
            <source>&amp;Previous panel</source>
            <translation>П&amp;редыдущая панель</translation>
        </message>
        <message>
            <source>As the &amp;system</source>
            <translation>Как в с&amp;истеме</translation>
        </message>
        <message>
            <source>&amp;Light</source>
            <translation>&amp;Светлая</translation>
        </message>
        <message>
            <source>&amp;Dark</source>
            <translation>&amp;Тёмная</translation>
        </message>
        <message>
            <source>High &amp;contrast</source>
            <translation>&amp;Контрастная</translation>
        </message>
        <message>
            <source>&amp;Keep the current run</source>
            <translation>&amp;Запомнить текущий расчёт</translation>
        </message>
        <message>
            <source>&amp;Help on the focused item</source>
            <translation>&amp;Справка по месту курсора</translation>
        </message>
        <message>
            <source>&amp;Contents</source>
            <translation>&amp;Содержание</translation>
        </message>
        <message>
            <source>&amp;Keyboard shortcuts</source>
            <translation>&amp;Клавиши</translation>
        </message>
        <message>
            <source>&amp;Tour of the window</source>
            <translation>&amp;Знакомство с окном</translation>
        </message>
        <message>
            <source>&amp;Log</source>
            <translation>&amp;Журнал</translation>
        </message>
        <message>
            <source>Export resu&amp;lts…</source>
            <translation>Экспорт &amp;результатов…</translation>
        </message>
        <message>
            <source>&amp;Font size</source>
            <translation>&amp;Размер шрифта</translation>
        </message>
        <message>
            <source>&amp;Smaller</source>
            <translation>&amp;Мелкий</translation>
        </message>
        <message>
            <source>&amp;Usual</source>
            <translation>&amp;Обычный</translation>
        </message>
        <message>
            <source>&amp;Larger</source>
            <translation>&amp;Крупный</translation>
        </message>
        <message>
            <source>La&amp;rgest</source>
            <translation>О&amp;чень крупный</translation>
        </message>
        <message>
            <source>%1: %2 %</source>
            <translation>%1: %2 %</translation>
        </message>
        <message>
            <source>Company and si&amp;gnatures…</source>
            <translation>Предприятие и &amp;подписи…</translation>
        </message>
        <message>
            <source>&amp;Part</source>
            <translation>&amp;Деталь</translation>
        </message>
        <message>
            <source>&amp;Add a surface…</source>
            <translation>&amp;Добавить поверхность…</translation>
        </message>
        <message>
            <source>&amp;Duplicate the surface…</source>
            <translation>&amp;Копия поверхности…</translation>
        </message>
        <message>
            <source>&amp;Rename the surface…</source>
            <translation>П&amp;ереименовать поверхность…</translation>
        </message>
        <message>
            <source>Grind it &amp;earlier</source>
            <translation>Шлифовать &amp;раньше</translation>
        </message>
        <message>
            <source>Grind it &amp;later</source>
            <translation>Шлифовать &amp;позже</translation>
        </message>
        <message>
            <source>Re&amp;move the surface</source>
            <translation>&amp;Удалить поверхность</translation>
        </message>
        <message>
            <source>&amp;Previous surface</source>
            <translation>Пред&amp;ыдущая поверхность</translation>
        </message>
        <message>
            <source>&amp;Next surface</source>
            <translation>&amp;Следующая поверхность</translation>
        </message>
        <message>
            <source>&amp;Whole part…</source>
            <translation>Деталь в &amp;целом…</translation>
        </message>
        <message>
            <source>&amp;Standard times and wheel wear…</source>
            <translation>&amp;Нормы времени и износ круга…</translation>
        </message>
        <message>
            <source>&amp;Study</source>
            <translation>&amp;Анализ</translation>
        </message>
        <message>
            <source>&amp;Calibrate from measurements…</source>
            <translation>&amp;Калибровка по измерениям…</translation>
        </message>
        <message>
            <source>&amp;Import measurements…</source>
            <translation>&amp;Импорт измерений…</translation>
        </message>
        <message>
            <source>Causes of &amp;waves on a part…</source>
            <translation>Причины &amp;волн на детали…</translation>
        </message>
        <message>
            <source>Parts &amp;between dressings…</source>
            <translation>Детали ме&amp;жду правками…</translation>
        </message>
        <message>
            <source>Packs &amp;for sharing</source>
            <translation>&amp;Наборы для передачи</translation>
        </message>
        <message>
            <source>&amp;Import a pack…</source>
            <translation>&amp;Импорт набора…</translation>
        </message>
        <message>
            <source>&amp;Export a pack…</source>
            <translation>&amp;Экспорт набора…</translation>
        </message>
        <message>
            <source>&amp;Lesson</source>
            <translation>&amp;Практикум</translation>
        </message>
        <message>
            <source>Laboratory &amp;works…</source>
            <translation>&amp;Лабораторные работы…</translation>
        </message>
        <message>
            <source>&amp;Previous step</source>
            <translation>&amp;Предыдущий шаг</translation>
        </message>
        <message>
            <source>&amp;Next step</source>
            <translation>&amp;Следующий шаг</translation>
        </message>
        <message>
            <source>&amp;Leave the lesson</source>
            <translation>&amp;Выйти из работы</translation>
        </message>
        <message>
            <source>&amp;Mark works…</source>
            <translation>П&amp;роверить работы…</translation>
        </message>
        <message>
            <source>&amp;Edit a work…</source>
            <translation>С&amp;оставить работу…</translation>
        </message>
        <message>
            <source>&amp;Title page of laboratory reports…</source>
            <translation>&amp;Титульный лист лабораторных отчётов…</translation>
        </message>
    </context>
    <context>
        <name>sparkout::BatchView</name>
        <message>
            <source>Batch</source>
            <translation>Партия</translation>
        </message>
        <message>
            <source>Point at a bar or a point to read its values.</source>
            <translation>Наведите указатель на столбец или точку, чтобы прочитать значения.</translation>
        </message>
        <message>
            <source>No factor scatters in this batch.</source>
            <translation>В этой партии ни один фактор не рассеивается.</translation>
        </message>
        <message>
            <source>This characteristic or one of the factors does not vary, or there are too few parts to show which factor matters.</source>
            <translation>Эта характеристика или один из факторов не меняется, либо деталей слишком мало, чтобы сказать, какой фактор важен.</translation>
        </message>
        <message>
            <source>Corner parts are not a sample: rank regression needs parts drawn at random.</source>
            <translation>Крайние сочетания — не выборка: для ранговой регрессии нужны случайные детали.</translation>
        </message>
        <message>
            <source>Sobol indices have no meaning for correlated factors.</source>
            <translation>Для коррелированных факторов индексы Соболя не имеют смысла.</translation>
        </message>
        <message>
            <source>Sobol indices need additional parts; these are being run.</source>
            <translation>Для индексов Соболя нужны собственные детали; они рассчитываются.</translation>
        </message>
        <message>
            <source>This characteristic does not vary, or some of the parts have none.</source>
            <translation>Эта характеристика не меняется, или у части деталей её нет.</translation>
        </message>
        <message>
            <source>The Sobol indices were stopped. “Run” runs them again.</source>
            <translation>Расчёт индексов Соболя остановлен. «Рассчитать» запустит его снова.</translation>
        </message>
        <message>
            <source>The inputs are refused; the batch is that of the last valid inputs.</source>
            <translation>Исходные данные не приняты; партия — по последним верным.</translation>
        </message>
        <message>
            <source>The batch cannot be run:</source>
            <translation>Партию нельзя рассчитать:</translation>
        </message>
        <message>
            <source>This batch takes a while: press “Run”. It can be stopped at any time and keeps the finished parts.</source>
            <translation>Эта партия считается дольше: нажмите «Рассчитать». Расчёт можно остановить в любой момент, сделанное сохранится.</translation>
        </message>
        <message>
            <source>Histograms, zone beside zone</source>
            <translation>Гистограммы по зонам рядом</translation>
        </message>
        <message>
            <source>Legend of the batch</source>
            <translation>Легенда партии</translation>
        </message>
        <message>
            <source>State of the batch</source>
            <translation>Состояние партии</translation>
        </message>
        <message>
            <source>Extent of the run</source>
            <translation>Что рассчитано</translation>
        </message>
        <message>
            <source>Values under the mouse</source>
            <translation>Значения под указателем</translation>
        </message>
        <message>
            <source>Progress of the batch</source>
            <translation>Ход расчёта партии</translation>
        </message>
        <message>
            <source>Quantities of the batch</source>
            <translation>Показатели партии</translation>
        </message>
        <message>
            <source>Histograms</source>
            <translation>Гистограммы</translation>
        </message>
        <message>
            <source>Sensitivity</source>
            <translation>Чувствительность</translation>
        </message>
        <message>
            <source>Scatter</source>
            <translation>Рассеяние</translation>
        </message>
        <message>
            <source>Which factor matters most</source>
            <translation>Какой фактор важнее всего</translation>
        </message>
        <message>
            <source>Parts, one quantity over another</source>
            <translation>Детали: один показатель в зависимости от другого</translation>
        </message>
        <message>
            <source>Rank regression</source>
            <translation>Ранговая регрессия</translation>
        </message>
        <message>
            <source>Sobol indices</source>
            <translation>Индексы Соболя</translation>
        </message>
        <message>
            <source>Measure of a factor&apos;s influence</source>
            <translation>Чем выражен вес фактора</translation>
        </message>
        <message>
            <source>Rank regression: standardised coefficients from the parts of the batch; sign and weight are valid as far as the dependence is monotone, which R² shows. Sobol indices: shares of the variance, from additional parts.</source>
            <translation>Ранговая регрессия: стандартизованные коэффициенты по деталям партии; знак и вес настолько, насколько зависимость монотонна, что показывает R². Индексы Соболя: доля дисперсии, по собственным деталям.</translation>
        </message>
        <message>
            <source>Quantity on the horizontal axis</source>
            <translation>Показатель по горизонтали</translation>
        </message>
        <message>
            <source>Quantity on the vertical axis</source>
            <translation>Показатель по вертикали</translation>
        </message>
        <message>
            <source>Displayed results of the batch</source>
            <translation>Что показано для партии</translation>
        </message>
        <message>
            <source>Characteristic</source>
            <translation>Характеристика</translation>
        </message>
        <message>
            <source>Run</source>
            <translation>Рассчитать</translation>
        </message>
        <message>
            <source>Run the parts of the batch; a quick one runs by itself</source>
            <translation>Рассчитать детали партии; короткая партия считается сама</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Остановить</translation>
        </message>
        <message>
            <source>Stop the batch; the completed parts are kept and shown</source>
            <translation>Остановить расчёт партии; сделанное сохраняется и показывается</translation>
        </message>
        <message>
            <source>Worst part</source>
            <translation>Худшая деталь</translation>
        </message>
        <message>
            <source>Add a typical batch</source>
            <translation>Добавить типовую партию</translation>
        </message>
        <message>
            <source>This project describes no batch. A batch is a number of parts whose stock, runout, dullness and other factors scatter: it shows which share of them meets the drawing. Choose the factors on the page Batch of the inputs, or start with the usual factors.</source>
            <translation>В проекте не описана партия. Партия — это детали, у которых припуск, биение, затупление и другие факторы рассеиваются: она показывает, какая их доля выдерживает чертёж. Выберите факторы на странице «Партия» исходных данных или начните с типовых.</translation>
        </message>
        <message>
            <source>50 parts whose stock, runout and dullness scatter about the current inputs; can be undone and changed on the page Batch</source>
            <translation>50 деталей, у которых припуск, биение и затупление рассеиваются вокруг текущих значений; можно отменить и изменить на странице «Партия»</translation>
        </message>
        <message>
            <source>No part of this batch fails a requirement.</source>
            <translation>Все детали этой партии выдержали все требования.</translation>
        </message>
        <message>
            <source>Rejects by cause</source>
            <translation>Брак по причинам</translation>
        </message>
        <message>
            <source>Rejects by cause, the most frequent first</source>
            <translation>Брак по причинам, сначала самая частая</translation>
        </message>
        <message>
            <source>Keep the part with the minimum margin as a run and compare it with this project, which stays unchanged</source>
            <translation>Запомнить деталь с наименьшим запасом как расчёт рядом с проектом и сравнить их; сам проект не изменится</translation>
        </message>
        <message>
            <source>All parts as CSV</source>
            <translation>Все детали в CSV</translation>
        </message>
        <message>
            <source>Run the batch again and save a row for every part: its factors, all quantities, and whether each requirement is met</source>
            <translation>Рассчитать партию ещё раз и сохранить по строке на деталь: её факторы, все показатели и выполнение каждого требования</translation>
        </message>
    </context>
    <context>
        <name>sparkout::BatchWait</name>
        <message>
            <source>The batch of this report is being run.</source>
            <translation>Рассчитывается партия для отчёта.</translation>
        </message>
        <message>
            <source>&amp;Stop</source>
            <translation>&amp;Остановить</translation>
        </message>
        <message>
            <source>Progress of the batch</source>
            <translation>Ход расчёта партии</translation>
        </message>
        <message>
            <source>Stop the batch; no report is written</source>
            <translation>Прекратить расчёт партии; отчёт не создаётся</translation>
        </message>
    </context>
    <context>
        <name>sparkout::BooleanEditor</name>
        <message>
            <source>yes</source>
            <translation>да</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CatalogueBar</name>
        <message>
            <source>Save as mine</source>
            <translation>Сохранить как своё</translation>
        </message>
        <message>
            <source>Your own catalogue cannot be read. “From catalogue…” shows the reason.</source>
            <translation>Ваш каталог не читается. Причина указана в окне «Из каталога…».</translation>
        </message>
        <message>
            <source>Your entry of this name will be replaced.</source>
            <translation>Ваша запись с этим именем будет заменена.</translation>
        </message>
        <message>
            <source>It will be shown in place of the shipped entry of this name.</source>
            <translation>Она будет показана вместо поставляемой записи с этим именем.</translation>
        </message>
        <message>
            <source>The values of this page will be kept as an entry of your own.</source>
            <translation>Значения этой страницы сохранятся как ваша собственная запись.</translation>
        </message>
        <message>
            <source>Not kept: %1</source>
            <translation>Не сохранено: %1</translation>
        </message>
        <message>
            <source>From catalogue…</source>
            <translation>Из каталога…</translation>
        </message>
        <message>
            <source>Apply values from the catalogue; the changes are shown first</source>
            <translation>Применить значения из каталога; сначала показано, что изменится</translation>
        </message>
        <message>
            <source>Save as mine…</source>
            <translation>Сохранить как своё…</translation>
        </message>
        <message>
            <source>Keep the values of this page as an entry of your own catalogue</source>
            <translation>Сохранить значения этой страницы в своём каталоге</translation>
        </message>
        <message>
            <source>&amp;Keep</source>
            <translation>&amp;Сохранить</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CatalogueDialog</name>
        <message>
            <source>Rename it, &amp;start a new one</source>
            <translation>Переименовать, со&amp;здать новый</translation>
        </message>
        <message>
            <source>&amp;Rename…</source>
            <translation>Пере&amp;именовать…</translation>
        </message>
        <message>
            <source>&amp;Delete…</source>
            <translation>&amp;Удалить…</translation>
        </message>
        <message>
            <source>Catalogue of materials</source>
            <translation>Каталог материалов</translation>
        </message>
        <message>
            <source>Catalogue of wheels</source>
            <translation>Каталог кругов</translation>
        </message>
        <message>
            <source>Catalogue of machines</source>
            <translation>Каталог станков</translation>
        </message>
        <message>
            <source>&amp;Apply</source>
            <translation>&amp;Применить</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>State of your catalogue</source>
            <translation>Состояние вашего каталога</translation>
        </message>
        <message>
            <source>Why the inputs would be refused</source>
            <translation>Почему исходные данные не будут приняты</translation>
        </message>
        <message>
            <source>Name, grade, marking, use or source</source>
            <translation>Имя, марка, маркировка, применение или источник</translation>
        </message>
        <message>
            <source>Search the catalogue</source>
            <translation>Поиск по каталогу</translation>
        </message>
        <message>
            <source>&amp;Search:</source>
            <translation>&amp;Поиск:</translation>
        </message>
        <message>
            <source>Entries found</source>
            <translation>Найдено записей</translation>
        </message>
        <message>
            <source>Entries</source>
            <translation>Записи</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Название</translation>
        </message>
        <message>
            <source>Whose</source>
            <translation>Чьё</translation>
        </message>
        <message>
            <source>Sources</source>
            <translation>Источники</translation>
        </message>
        <message>
            <source>Resulting changes</source>
            <translation>Что изменится</translation>
        </message>
        <message>
            <source>Input</source>
            <translation>Исходная величина</translation>
        </message>
        <message>
            <source>Now</source>
            <translation>Сейчас</translation>
        </message>
        <message>
            <source>Then</source>
            <translation>Станет</translation>
        </message>
        <message>
            <source>Source</source>
            <translation>Источник</translation>
        </message>
        <message>
            <source>The chosen entry</source>
            <translation>Выбранная запись</translation>
        </message>
        <message>
            <source>mine</source>
            <translation>своя</translation>
        </message>
        <message>
            <source>shipped</source>
            <translation>из поставки</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 из %2</translation>
        </message>
        <message>
            <source>No entry has all these words.</source>
            <translation>Ни в одной записи нет всех этих слов.</translation>
        </message>
        <message>
            <source>It changes nothing.</source>
            <translation>Ничего не изменится.</translation>
        </message>
        <message numerus="yes">
            <source>%n inputs change (in bold); the others stay as they are.</source>
            <translation>
                <numerusform>Изменится %n величина (выделена); остальные останутся как есть.</numerusform>
                <numerusform>Изменятся %n величины (выделены); остальные останутся как есть.</numerusform>
                <numerusform>Изменятся %n величин (выделены); остальные останутся как есть.</numerusform>
            </translation>
        </message>
        <message>
            <source>The compliance is given on this page, so the stiffness is not used.</source>
            <translation>Податливость на этой странице задана, поэтому жёсткость не используется.</translation>
        </message>
        <message>
            <source>This entry would make the inputs invalid: %1</source>
            <translation>С этой записью исходные данные не будут приняты: %1</translation>
        </message>
        <message>
            <source>Your own entries cannot be read and are left as they are in %1: %2</source>
            <translation>Ваши записи не читаются и оставлены как есть в %1: %2</translation>
        </message>
        <message>
            <source>The unreadable file is kept as %1.</source>
            <translation>Нечитаемый файл сохранён как %1.</translation>
        </message>
        <message>
            <source>Rename the entry</source>
            <translation>Переименовать запись</translation>
        </message>
        <message>
            <source>You already have an entry with this name.</source>
            <translation>У вас уже есть запись с этим именем.</translation>
        </message>
        <message>
            <source>Delete “%1” from your catalogue? Projects that use it keep their values.</source>
            <translation>Удалить «%1» из вашего каталога? Проекты, где она взята, сохранят свои значения.</translation>
        </message>
        <message>
            <source>Nothing was changed in your catalogue: %1</source>
            <translation>В вашем каталоге ничего не изменено: %1</translation>
        </message>
        <message>
            <source>&amp;Rename</source>
            <translation>&amp;Переименовать</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CompanyDialog</name>
        <message>
            <source>&amp;Remove</source>
            <translation>&amp;Удалить</translation>
        </message>
        <message>
            <source>Company and signatures</source>
            <translation>Предприятие и подписи</translation>
        </message>
        <message>
            <source>Printed in the heads of documents, in those of every project. All of it may be empty.</source>
            <translation>Печатается в заголовках документов всех проектов. Любое поле можно оставить пустым.</translation>
        </message>
        <message>
            <source>&amp;Logo…</source>
            <translation>&amp;Логотип…</translation>
        </message>
        <message>
            <source>Logo</source>
            <translation>Логотип</translation>
        </message>
        <message>
            <source>&amp;Keep</source>
            <translation>&amp;Сохранить</translation>
        </message>
        <message>
            <source>Cance&amp;l</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>Choose a logo</source>
            <translation>Выбор логотипа</translation>
        </message>
        <message>
            <source>Pictures (*.png *.jpg *.jpeg);;All files (*)</source>
            <translation>Рисунки (*.png *.jpg *.jpeg);;Все файлы (*)</translation>
        </message>
        <message>
            <source>The logo stays as it was.</source>
            <translation>Логотип остался прежним.</translation>
        </message>
        <message>
            <source>none</source>
            <translation>нет</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CompareView</name>
        <message>
            <source>Compare</source>
            <translation>Сравнение</translation>
        </message>
        <message>
            <source>Curves of the compared runs</source>
            <translation>Кривые сравниваемых расчётов</translation>
        </message>
        <message>
            <source>Legend of quantities and runs</source>
            <translation>Обозначения показателей и расчётов</translation>
        </message>
        <message>
            <source>State of the comparison</source>
            <translation>Состояние сравнения</translation>
        </message>
        <message>
            <source>Values under the mouse</source>
            <translation>Значения под указателем</translation>
        </message>
        <message>
            <source>Inputs and results that differ</source>
            <translation>Различающиеся исходные данные и результаты</translation>
        </message>
        <message>
            <source>Next step</source>
            <translation>Следующий шаг</translation>
        </message>
        <message>
            <source>Zone or section whose curves are drawn</source>
            <translation>Зона или сечение, кривые которых показаны</translation>
        </message>
        <message>
            <source>Horizontal axis</source>
            <translation>Горизонтальная ось</translation>
        </message>
        <message>
            <source>Keep the current run</source>
            <translation>Запомнить текущий расчёт</translation>
        </message>
        <message>
            <source>Current run</source>
            <translation>Текущий расчёт</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>now: %1</source>
            <translation>сейчас: %1</translation>
        </message>
        <message>
            <source>Point at a curve to read its values beside those of the current run.</source>
            <translation>Наведите указатель на кривую: её значения встанут рядом со значениями текущего расчёта.</translation>
        </message>
        <message>
            <source>No run is kept yet. Keep the current run and change the inputs; the curves of both runs, and the inputs and results that differ, are shown here.</source>
            <translation>Пока не запомнен ни один расчёт. Запомните текущий и измените исходные данные — здесь станет видно, что изменилось.</translation>
        </message>
        <message>
            <source>Check a run in the list to draw it over the current run.</source>
            <translation>Отметьте расчёт в списке, чтобы наложить его на текущий.</translation>
        </message>
        <message>
            <source>The chosen runs have the same inputs and results as the current run.</source>
            <translation>У отмеченных расчётов те же исходные данные и результаты, что у текущего.</translation>
        </message>
        <message>
            <source>The inputs are refused; the current run is that of the last valid inputs.</source>
            <translation>Исходные данные не приняты; текущий расчёт — по последним верным.</translation>
        </message>
        <message>
            <source>The cycle is too long to be recorded: its curves are not drawn. Fewer radii or sections help.</source>
            <translation>Цикл слишком долгий для записи: кривые не показаны. Помогает меньшее число радиусов или сечений.</translation>
        </message>
        <message>
            <source>“%1” can no longer be run: %2</source>
            <translation>«%1» больше нельзя рассчитать: %2</translation>
        </message>
        <message>
            <source>its results cannot be read</source>
            <translation>его итоги не читаются</translation>
        </message>
        <message numerus="yes">
            <source>; and %n more</source>
            <translation>
                <numerusform>; и ещё %n</numerusform>
                <numerusform>; и ещё %n</numerusform>
                <numerusform>; и ещё %n</numerusform>
            </translation>
        </message>
        <message>
            <source>“%1” was kept by version %2 of the program; this version gives different results: %3</source>
            <translation>«%1» запомнен версией программы %2 и теперь получается иначе: %3</translation>
        </message>
        <message>
            <source>“%1” is too long to be recorded: its curves are not drawn.</source>
            <translation>«%1» слишком долгий для записи: его кривые не показаны.</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>Double strokes</source>
            <translation>Двойные ходы</translation>
        </message>
        <message>
            <source>Revolutions</source>
            <translation>Обороты</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ComplianceBox</name>
        <message>
            <source>Section %1</source>
            <translation>Сечение %1</translation>
        </message>
        <message>
            <source>Compliance of %1</source>
            <translation>Податливость, %1</translation>
        </message>
        <message>
            <source>%1 %2</source>
            <translation>%1 %2</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <comment>zone: compliance</comment>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Computed compliance</source>
            <translation>Вычисленная податливость</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CompliancePlot</name>
        <message>
            <source>ground length</source>
            <translation>шлифуемая длина</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ComplianceView</name>
        <message>
            <source>Point at the curve to read the values.</source>
            <translation>Наведите указатель на кривую, чтобы прочитать значения.</translation>
        </message>
        <message>
            <source>Compliance</source>
            <translation>Податливость</translation>
        </message>
        <message>
            <source>%1 yields %2 times as much as %3.</source>
            <translation>%1 поддаётся в %2 раза сильнее, чем %3.</translation>
        </message>
        <message>
            <source>Compliance along the part</source>
            <translation>Податливость вдоль детали</translation>
        </message>
        <message>
            <source>Legend of the curves</source>
            <translation>Обозначения кривых</translation>
        </message>
        <message>
            <source>State of the curves</source>
            <translation>Состояние кривых</translation>
        </message>
        <message>
            <source>Values under the mouse</source>
            <translation>Значения под указателем</translation>
        </message>
        <message>
            <source>Most compliant place</source>
            <translation>Где поддаётся сильнее всего</translation>
        </message>
        <message>
            <source>Uniform along the length.</source>
            <translation>Одинакова по всей длине.</translation>
        </message>
        <message>
            <source>Stages end by the position of the wheel head: the position of the gauge has no effect.</source>
            <translation>Ступени заканчиваются по положению шлифовальной бабки: прибор не действует, и все его места равноценны.</translation>
        </message>
        <message>
            <source>In traverse grinding the gauge is in the middle of %1. The curves show its effect in another zone.</source>
            <translation>При шлифовании с продольной подачей прибор стоит посередине %1. Кривые показывают, что было бы в другой зоне.</translation>
        </message>
        <message>
            <source>Sections are coupled in plunge grinding only: there the wheel touches all of them at once.</source>
            <translation>Сечения связаны только при врезном шлифовании: там круг касается всех сразу.</translation>
        </message>
        <message>
            <source>Computing… %1 of %2</source>
            <translation>Идёт расчёт… %1 из %2</translation>
        </message>
        <message>
            <source>Computing…</source>
            <translation>Идёт расчёт…</translation>
        </message>
        <message>
            <source>The cycle does not reach size with the gauge in any place.</source>
            <translation>Ни с одного места прибора цикл не выходит на размер.</translation>
        </message>
        <message>
            <source>%1 mm</source>
            <translation>%1 мм</translation>
        </message>
        <message>
            <source>Best place: %1; there all diameters are within %2 µm of the middle of the tolerance band. Current place, %3 mm: %4 µm.</source>
            <translation>Лучшее место: %1; там ни один диаметр не дальше %2 мкм от середины поля. Сейчас, на %3 мм: %4 мкм.</translation>
        </message>
        <message>
            <source>Position of the gauge</source>
            <translation>Положение прибора</translation>
        </message>
        <message>
            <source>Coupled against independent sections</source>
            <translation>Связанные и независимые сечения</translation>
        </message>
        <message>
            <source>Curves below the part</source>
            <translation>Что показано под деталью</translation>
        </message>
        <message>
            <source>Put the gauge there</source>
            <translation>Поставить прибор туда</translation>
        </message>
        <message>
            <source>Sets the gauge&apos;s free position to the best place; can be undone</source>
            <translation>Сделать лучшее место местом прибора; можно отменить</translation>
        </message>
        <message>
            <source>The compliance is given, zone by zone or section by section. Choose “from stiffness and shaft” on the page Machine to see its components.</source>
            <translation>Податливость задана по зонам или сечениям. Выберите «по жёсткости узлов и валу» на странице «Станок», чтобы увидеть, из чего она складывается.</translation>
        </message>
        <message>
            <source>The compliance is given section by section, which does not determine how a force in one section deflects another. Choose “from stiffness and shaft” on the page Machine.</source>
            <translation>Податливость задана по сечениям, а это не говорит, как одно сечение отжимает другое. Выберите «по жёсткости узлов и валу» на странице «Станок».</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ConstraintsView</name>
        <message>
            <source>Constraints</source>
            <translation>Ограничения</translation>
        </message>
        <message>
            <source>%1 — %2</source>
            <translation>%1 — %2</translation>
        </message>
        <message>
            <source>Choose a requirement to see where it was worst and how its value arose.</source>
            <translation>Выберите требование: здесь появится, где оно ближе всего к пределу и как получено число.</translation>
        </message>
        <message>
            <source>%1, %2: a setting compared with its range.</source>
            <translation>%1 (%2): настройка сверяется с диапазоном станка.</translation>
        </message>
        <message>
            <source>The cycle is too long to be recorded: its cuts are not drawn. Fewer radii or sections help; the requirements below apply to the whole cycle.</source>
            <translation>Цикл слишком длинный для записи, проходы не показаны. Помогает меньше радиусов или сечений; требования ниже — по всему циклу.</translation>
        </message>
        <message>
            <source>No limit of the feed is active, so any feed is allowed: enter the burn limit of the material, or the power of a drive. The links below lead to the fields.</source>
            <translation>Подачу ничто не ограничивает: задайте температуру прижога материала или мощность привода. Ссылки внизу ведут к полям.</translation>
        </message>
        <message>
            <source>Actual feed under its limits</source>
            <translation>Фактическая подача и её пределы</translation>
        </message>
        <message>
            <source>Legend of the curves</source>
            <translation>Обозначения кривых</translation>
        </message>
        <message>
            <source>State of the curves</source>
            <translation>Состояние кривых</translation>
        </message>
        <message>
            <source>Values under the mouse</source>
            <translation>Значения под указателем</translation>
        </message>
        <message>
            <source>Requirements that are not checked</source>
            <translation>Требования, которые не проверяются</translation>
        </message>
        <message>
            <source>Requirements by the used share of their limit</source>
            <translation>Требования по доле занятого предела</translation>
        </message>
        <message>
            <source>Origin of the value</source>
            <translation>Как получено число</translation>
        </message>
        <message>
            <source>Logarithmic</source>
            <translation>Логарифм.</translation>
        </message>
        <message>
            <source>Every place</source>
            <translation>Все места</translation>
        </message>
        <message>
            <source>Show where</source>
            <translation>Показать, где</translation>
        </message>
        <message>
            <source>Zone or section with the used share of its limit. In a reversal zone, the width of cut depends on whether the wheel stands or travels.</source>
            <translation>Зона или сечение; в реверсной зоне круг стоит или ходит, ширина шлифования при этом разная. Рядом — наибольшая доля предела.</translation>
        </message>
        <message>
            <source>Actual feeds on a logarithmic axis: spark-out and distant limits in one plot</source>
            <translation>Фактические подачи по логарифмической оси: выхаживание и далёкие пределы на одном графике</translation>
        </message>
        <message>
            <source>Every zone, section and stage; otherwise the worst of each requirement</source>
            <translation>Все зоны, сечения и ступени; иначе худшее место каждого требования</translation>
        </message>
        <message>
            <source>Goes to the passes, the profile or the field behind the requirement; also Enter or a double click on its row</source>
            <translation>К проходам, профилю или полю, от которых зависит требование; то же — Enter или двойной щелчок по строке</translation>
        </message>
        <message>
            <source>Point at the curve to read the values.</source>
            <translation>Наведите указатель на кривую, чтобы прочитать значения.</translation>
        </message>
        <message>
            <source>Coupled sections share the power of the drives, so it does not limit the feed of a single section. The requirements below apply to the whole length.</source>
            <translation>Связанные сечения делят мощность приводов, поэтому подачу отдельного сечения она не ограничивает. Ниже, в требованиях, с ней сравнивается вся длина.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CopyTable</name>
        <message>
            <source>Copy the table</source>
            <translation>Копировать таблицу</translation>
        </message>
        <message>
            <source>CSV for &amp;Russian Excel: semicolons, decimal commas…</source>
            <translation>CSV для &amp;русского Excel: точка с запятой, десятичная запятая…</translation>
        </message>
        <message>
            <source>&amp;English CSV: commas, decimal points…</source>
            <translation>&amp;Английский CSV: запятая, десятичная точка…</translation>
        </message>
        <message>
            <source>Ctrl+C copies the selected rows, Ctrl+Shift+C the table; its menu saves it</source>
            <translation>Ctrl+C копирует выбранные строки, Ctrl+Shift+C — таблицу; контекстное меню сохраняет её в файл</translation>
        </message>
        <message>
            <source>Save the table as</source>
            <translation>Сохранить таблицу как</translation>
        </message>
        <message>
            <source>Copy the selected rows</source>
            <translation>Копировать выбранные строки</translation>
        </message>
        <message>
            <source>Columns</source>
            <translation>Столбцы</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CorrelationBox</name>
        <message>
            <source>%1 – %2</source>
            <comment>two factors</comment>
            <translation>%1 – %2</translation>
        </message>
        <message>
            <source>Between −1 and 1; 0: independent. Of normal factors Pearson&apos;s coefficient, of others nearly Spearman&apos;s.</source>
            <translation>От −1 до 1; 0 — независимы. Для нормальных факторов — коэффициент Пирсона, для прочих — почти Спирмена.</translation>
        </message>
        <message>
            <source>row %1, column %1: “%2” is not 1</source>
            <translation>строка %1, столбец %1: «%2» — не 1</translation>
        </message>
        <message>
            <source>row %1, column %2: “%3” differs from “%4” across the diagonal</source>
            <translation>строка %1, столбец %2: «%3» не равно числу по другую сторону диагонали, «%4»</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CursorModel</name>
        <message>
            <source>Curve</source>
            <translation>Кривая</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CursorStrip</name>
        <message>
            <source>Cursors</source>
            <translation>Курсоры</translation>
        </message>
        <message>
            <source>Values at the cursors and their differences</source>
            <translation>Значения у курсоров и их разности</translation>
        </message>
        <message>
            <source>Place of cursor %1</source>
            <translation>Положение курсора %1</translation>
        </message>
        <message>
            <source>B − A = %1</source>
            <translation>B − A = %1</translation>
        </message>
        <message>
            <source>Distance of the cursors</source>
            <translation>Разность положений</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ExamplesDialog</name>
        <message>
            <source>Example gallery</source>
            <translation>Примеры</translation>
        </message>
        <message>
            <source>Examples</source>
            <translation>Примеры</translation>
        </message>
        <message>
            <source>Notes of the example</source>
            <translation>Примечания к примеру</translation>
        </message>
        <message>
            <source>The example is opened as a copy; the shipped one stays as it is.</source>
            <translation>Пример открывается как копия; поставляемый остаётся без изменений.</translation>
        </message>
        <message>
            <source>&amp;Open a copy</source>
            <translation>&amp;Открыть копию</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>%1
%2</source>
            <translation>%1
%2</translation>
        </message>
        <message>
            <source>%1. %2. %3.</source>
            <translation>%1. %2. %3.</translation>
        </message>
        <message>
            <source>%1

%2</source>
            <translation>%1

%2</translation>
        </message>
        <message numerus="yes">
            <source>%n surfaces in one set-up</source>
            <translation>
                <numerusform>%n поверхность за один установ</numerusform>
                <numerusform>%n поверхности за один установ</numerusform>
                <numerusform>%n поверхностей за один установ</numerusform>
            </translation>
        </message>
        <message>
            <source>Not every cycle ends at size.</source>
            <translation>Не каждый цикл выходит на размер.</translation>
        </message>
        <message>
            <source>Main time %1, piece time %2.</source>
            <translation>Основное время %1, штучное время %2.</translation>
        </message>
        <message>
            <source>Main time %1.</source>
            <translation>Основное время %1.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ExportCommands</name>
        <message>
            <source>No results</source>
            <translation>Нет результатов</translation>
        </message>
        <message>
            <source>There is no result of these inputs, so there is nothing to export. The messages list the faults.</source>
            <translation>С этими исходными данными результата нет, экспортировать нечего. Что в них не так, сказано в сообщениях.</translation>
        </message>
        <message>
            <source>Results</source>
            <translation>Результаты</translation>
        </message>
        <message>
            <source>Export results</source>
            <translation>Экспорт результатов</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ExportDialog</name>
        <message>
            <source>Export results</source>
            <translation>Экспорт результатов</translation>
        </message>
        <message>
            <source>XLSX workbook</source>
            <translation>Книга XLSX</translation>
        </message>
        <message>
            <source>CSV for Russian Excel: semicolons, decimal commas</source>
            <translation>CSV для русского Excel: точка с запятой, десятичная запятая</translation>
        </message>
        <message>
            <source>English CSV: commas, decimal points</source>
            <translation>Английский CSV: запятая, десятичная точка</translation>
        </message>
        <message>
            <source>JSON for programs</source>
            <translation>JSON для программ</translation>
        </message>
        <message>
            <source>Format</source>
            <translation>Формат</translation>
        </message>
        <message>
            <source>Content</source>
            <translation>Содержание</translation>
        </message>
        <message>
            <source>&amp;Format:</source>
            <translation>&amp;Формат:</translation>
        </message>
        <message>
            <source>&amp;Content:</source>
            <translation>&amp;Содержание:</translation>
        </message>
        <message>
            <source>Choose the &amp;place…</source>
            <translation>&amp;Выбрать место…</translation>
        </message>
        <message>
            <source>C&amp;ancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>Inputs, results, requirements and the trace</source>
            <translation>Исходные данные, результаты, требования и трасса</translation>
        </message>
        <message>
            <source>The same without the trace</source>
            <translation>То же без трассы</translation>
        </message>
        <message>
            <source>Results, shop figures and requirements</source>
            <translation>Результаты, показатели шлифования и требования</translation>
        </message>
        <message>
            <source>The object that the command line prints for a run; its keys are the same in every language.</source>
            <translation>Объект, который печатает о расчёте командная строка; его ключи на всех языках одинаковы.</translation>
        </message>
        <message>
            <source>Every part on separate sheets; the trace has %1 rows on %2 sheets, a row for every pass of a radius under the wheel.</source>
            <translation>Каждая часть на своих листах; в трассе %1 строк на %2 листах, по строке на каждое прохождение радиуса под кругом.</translation>
        </message>
        <message>
            <source>Every part on a separate sheet.</source>
            <translation>Каждая часть на своём листе.</translation>
        </message>
        <message>
            <source>One table; it has %1 rows, a row for every pass of a radius under the wheel.</source>
            <translation>Одна таблица; в ней %1 строк, по строке на каждое прохождение радиуса под кругом.</translation>
        </message>
        <message>
            <source>One table.</source>
            <translation>Одна таблица.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FactorBox</name>
        <message>
            <source>constant</source>
            <translation>постоянное</translation>
        </message>
        <message>
            <source>uniform</source>
            <translation>равномерное</translation>
        </message>
        <message>
            <source>normal</source>
            <translation>нормальное</translation>
        </message>
        <message>
            <source>triangular</source>
            <translation>треугольное</translation>
        </message>
        <message>
            <source>as measured</source>
            <translation>по измерениям</translation>
        </message>
        <message>
            <source>growing part by part</source>
            <translation>растёт по деталям</translation>
        </message>
        <message>
            <source>Read measured blanks</source>
            <translation>Прочитать измеренные заготовки</translation>
        </message>
        <message>
            <source>Tables (*.csv *.txt *.tsv *.dat);;All files (*)</source>
            <translation>Таблицы (*.csv *.txt *.tsv *.dat);;Все файлы (*)</translation>
        </message>
        <message>
            <source>“%1” was not read: %2</source>
            <translation>Файл «%1» не принят: %2</translation>
        </message>
        <message>
            <source>no column is headed “%1”</source>
            <translation>нет столбца с заголовком «%1»</translation>
        </message>
        <message>
            <source>line %1: “%2” is not a number</source>
            <translation>строка %1: «%2» — не число</translation>
        </message>
        <message>
            <source>no values yet</source>
            <translation>значений ещё нет</translation>
        </message>
        <message numerus="yes">
            <source>%n values, %1…%2 %3</source>
            <translation>
                <numerusform>%n значение, %1…%2 %3</numerusform>
                <numerusform>%n значения, %1…%2 %3</numerusform>
                <numerusform>%n значений, %1…%2 %3</numerusform>
            </translation>
        </message>
        <message>
            <source>Ticked: it scatters from part to part.</source>
            <translation>Отмечено: рассеивается от детали к детали.</translation>
        </message>
        <message>
            <source>Distribution</source>
            <translation>Распределение</translation>
        </message>
        <message>
            <source>%1: distribution</source>
            <translation>%1: распределение</translation>
        </message>
        <message>
            <source>truncated</source>
            <translation>усечённое</translation>
        </message>
        <message>
            <source>%1: truncated</source>
            <translation>%1: усечённое</translation>
        </message>
        <message>
            <source>Read from CSV…</source>
            <translation>Прочитать из CSV…</translation>
        </message>
        <message>
            <source>%1: read from a CSV file</source>
            <translation>%1: прочитать из файла CSV</translation>
        </message>
        <message>
            <source>A table whose column “%1” has one value per line</source>
            <translation>Таблица, в столбце «%1» которой в каждой строке значение</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FaultsDialog</name>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>The file was not opened</source>
            <translation>Файл не открыт</translation>
        </message>
        <message>
            <source>“%1” is refused for these reasons. The project in the window is unchanged.</source>
            <translation>Файл «%1» не принят по следующим причинам. Проект в окне остался прежним.</translation>
        </message>
        <message>
            <source>Faults of the file</source>
            <translation>Ошибки файла</translation>
        </message>
        <message>
            <source>&amp;Copy the list</source>
            <translation>&amp;Копировать список</translation>
        </message>
        <message>
            <source>C&amp;lose</source>
            <translation>&amp;Закрыть</translation>
        </message>
        <message>
            <source>%1 (%2): %3</source>
            <translation>%1 (%2): %3</translation>
        </message>
        <message>
            <source>“%1” is open, but these values are refused:</source>
            <translation>«%1» открыт, но эти значения не приняты:</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FeedsNote</name>
        <message>
            <source>How to read the feeds</source>
            <translation>Как читать графики подач</translation>
        </message>
        <message>
            <source>Steps of a double stroke in each zone</source>
            <translation>Этапы двойного хода в каждой зоне</translation>
        </message>
        <message>
            <source>Explanation</source>
            <translation>Пояснение</translation>
        </message>
        <message>
            <source>E1…E5 number the steps in which a zone is ground during one double stroke, so the same number is another step in another zone. They are shown when a few double strokes are shown.</source>
            <translation>Э1…Э5 — номера этапов, на которых зона шлифуется за один двойной ход, поэтому в разных зонах один номер означает разное. Этапы показаны, когда на графике немного двойных ходов.</translation>
        </message>
        <message>
            <source>With infeed at the exit, RZ2 is ground in E4 between its E1 and E2.</source>
            <translation>При подаче у выхода этап Э4 зоны РЗ2 стоит между её этапами Э1 и Э2.</translation>
        </message>
        <message>
            <source>A zone is shown as ground during the whole stroke, as in the model: the position of the wheel within a stroke is not resolved.</source>
            <translation>Зона показана шлифуемой в течение всего хода, как принято в модели: положение круга внутри хода не различается.</translation>
        </message>
        <message>
            <source>Over the whole cycle a point is a double stroke: feeds are summed over its passes, the force is that of its hardest pass. Zoomed in, a point is one pass, and within one double stroke it is one radius under the wheel.</source>
            <translation>На графике всего цикла точка — двойной ход: подачи просуммированы по его проходам, сила — наибольшая из средних по проходам. При увеличении точка — один проход, а в пределах одного двойного хода — один радиус под кругом.</translation>
        </message>
        <message>
            <source>All sections are fed alike; they differ by their compliance.</source>
            <translation>Программная подача всех сечений одинакова, различается их податливость.</translation>
        </message>
        <message>
            <source>A point is one revolution, in long cycles several of them; zoomed in, it is one radius under the wheel.</source>
            <translation>Точка — один оборот, в длинных циклах несколько оборотов; при увеличении — один радиус под кругом.</translation>
        </message>
        <message>
            <source>The spread reaches from the minimum to the maximum value over the radii of a cross-section, the line is their mean.</source>
            <translation>Разброс — от наименьшего до наибольшего значения по радиусам поперечного сечения, линия — их среднее.</translation>
        </message>
        <message>
            <source>C&amp;lose</source>
            <translation>&amp;Закрыть</translation>
        </message>
        <message>
            <source>The thick vertical line marks the moment of the cycle; the bar below the views or a click in a plot moves it. Without the line, the plots show the end of the cycle.</source>
            <translation>Толстая вертикальная линия показывает, где сейчас цикл: её двигает панель под графиками и щелчок по графику. Без линии цикл показан до конца.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FeedsOverview</name>
        <message>
            <source>Overview of the whole cycle</source>
            <translation>Обзор всего цикла</translation>
        </message>
        <message>
            <source>Arrows move the visible part, with Shift its end, with Ctrl its beginning; Home shows the whole cycle.</source>
            <translation>Стрелки сдвигают видимый участок, с Shift — его конец, с Ctrl — его начало; Home показывает весь цикл.</translation>
        </message>
        <message>
            <source>Actual feed over the whole cycle. Drag the window or its edges; the wheel zooms; a double click shows the whole cycle.</source>
            <translation>Фактическая подача за весь цикл. Окно и его края перетаскиваются, колёсико меняет масштаб, двойной щелчок показывает весь цикл.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FeedsPlot</name>
        <message>
            <source>spread over the radii</source>
            <translation>разброс по радиусам</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FeedsView</name>
        <message>
            <source>Feeds by stage</source>
            <translation>Подачи по ступеням</translation>
        </message>
        <message>
            <source>Curves of the feeds by stage</source>
            <translation>Кривые подач по ступеням</translation>
        </message>
        <message>
            <source>Legend of the curves</source>
            <translation>Обозначения кривых</translation>
        </message>
        <message>
            <source>State of the curves</source>
            <translation>Состояние кривых</translation>
        </message>
        <message>
            <source>Values under the pointer</source>
            <translation>Значения под указателем</translation>
        </message>
        <message>
            <source>Visible part of the cycle</source>
            <translation>Видимая часть цикла</translation>
        </message>
        <message>
            <source>Free choice</source>
            <translation>Свободный выбор</translation>
        </message>
        <message>
            <source>Horizontal axis</source>
            <translation>Горизонтальная ось</translation>
        </message>
        <message>
            <source>Section that is also shown</source>
            <translation>Дополнительно показанное сечение</translation>
        </message>
        <message>
            <source>No.</source>
            <comment>number of the double stroke or revolution</comment>
            <translation>№</translation>
        </message>
        <message>
            <source>Previous</source>
            <translation>Предыдущий</translation>
        </message>
        <message>
            <source>Next</source>
            <translation>Следующий</translation>
        </message>
        <message>
            <source>Point at a curve to read its values.</source>
            <translation>Наведите указатель на кривую, чтобы прочитать значения.</translation>
        </message>
        <message>
            <source>%1 values are not numbers and are not drawn.</source>
            <translation>Не показано нечисловых значений: %1.</translation>
        </message>
        <message>
            <source>Whole cycle</source>
            <translation>Весь цикл</translation>
        </message>
        <message>
            <source>Stage %1</source>
            <translation>Ступень %1</translation>
        </message>
        <message>
            <source>One double stroke</source>
            <translation>Один двойной ход</translation>
        </message>
        <message>
            <source>One revolution</source>
            <translation>Один оборот</translation>
        </message>
        <message>
            <source>Number of the double stroke</source>
            <translation>Номер двойного хода</translation>
        </message>
        <message>
            <source>Number of the revolution</source>
            <translation>Номер оборота</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>Double strokes</source>
            <translation>Двойные ходы</translation>
        </message>
        <message>
            <source>Revolutions</source>
            <translation>Обороты</translation>
        </message>
        <message>
            <source>Evenly chosen</source>
            <translation>Выборочно</translation>
        </message>
        <message>
            <source>The cycle is too long to draw: %1 visits of a radius, at most %2 are recorded. Fewer radii or sections help; the verdict applies to the whole cycle.</source>
            <translation>Цикл слишком длинный для построения: %1 прохождений радиусов, записывается не более %2. Помогает меньшее число радиусов или сечений; заключение относится ко всему циклу.</translation>
        </message>
        <message>
            <source>How to read the feeds</source>
            <translation>Как читать графики подач</translation>
        </message>
        <message>
            <source>How to read the feeds: the steps E1…E5 and the curves</source>
            <translation>Как читать графики подач: этапы Э1…Э5 и кривые</translation>
        </message>
        <message>
            <source>Feeds</source>
            <comment>the view&apos;s tab</comment>
            <translation>Подачи</translation>
        </message>
        <message>
            <source>measured traces</source>
            <translation>записи измерений</translation>
        </message>
        <message>
            <source>Measured traces beside the simulated curves</source>
            <translation>Записи измерений рядом с расчётными кривыми</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FileCommands</name>
        <message>
            <source>Opening %1</source>
            <translation>Открывается %1</translation>
        </message>
        <message>
            <source>The file was not opened</source>
            <translation>Файл не открыт</translation>
        </message>
        <message>
            <source>Untitled</source>
            <translation>Без имени</translation>
        </message>
        <message>
            <source>Opened: %1</source>
            <translation>Открыто: %1</translation>
        </message>
        <message>
            <source>Open a project or a lesson</source>
            <translation>Открыть проект или лабораторную работу</translation>
        </message>
        <message>
            <source>Projects, lessons and works (*.sparkout *.sparkout-lesson *.sparkout-work);;All files (*)</source>
            <translation>Проекты и лабораторные работы (*.sparkout *.sparkout-lesson *.sparkout-work);;Все файлы (*)</translation>
        </message>
        <message>
            <source>%1 contains no project. Cards, passports, hand-outs and drawings written by Sparkout contain one.</source>
            <translation>%1 не содержит проекта. Он вложен в карты, паспорта, раздаточные материалы и рисунки, которые пишет Sparkout.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ProjectSaver</name>
        <message>
            <source>Save the project</source>
            <translation>Сохранить проект</translation>
        </message>
        <message>
            <source>Sparkout projects (*.sparkout)</source>
            <translation>Проекты Sparkout (*.sparkout)</translation>
        </message>
        <message>
            <source>Saved: %1</source>
            <translation>Сохранён: %1</translation>
        </message>
        <message>
            <source>%1 copy</source>
            <translation>%1 (копия)</translation>
        </message>
        <message>
            <source>The project is not complete</source>
            <translation>Проект не заполнен</translation>
        </message>
        <message>
            <source>It can be saved once its drawing is given. Still needed:</source>
            <translation>Его можно сохранить, когда будет задан чертёж. Ещё нужны:</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FileNotices</name>
        <message>
            <source>Kept runs of this file contain inputs that this version refuses. They stay in the file unchanged but cannot be computed again.</source>
            <translation>В запомненных расчётах этого файла есть исходные данные, которые эта версия не принимает. Они останутся в файле как есть, но пересчитать их нельзя.</translation>
        </message>
        <message>
            <source>Show…</source>
            <translation>Показать…</translation>
        </message>
        <message>
            <source>“%1” is open read-only. Saving asks for another name.</source>
            <translation>«%1» открыт только для чтения. При сохранении будет спрошено другое имя.</translation>
        </message>
        <message>
            <source>Save as…</source>
            <translation>Сохранить как…</translation>
        </message>
        <message>
            <source>Reload</source>
            <translation>Перезагрузить</translation>
        </message>
        <message>
            <source>“%1” was removed or renamed by another program. The project now exists only in this window.</source>
            <translation>«%1» удалён или переименован другой программой. Проект теперь есть только в этом окне.</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Сохранить</translation>
        </message>
        <message>
            <source>“%1” was changed by another program while it has unsaved changes here. Saving will ask which version counts.</source>
            <translation>«%1» изменён другой программой, а здесь есть несохранённые изменения. При сохранении будет спрошено, какая версия нужна.</translation>
        </message>
        <message>
            <source>“%1” was changed by another program. Reload it?</source>
            <translation>«%1» изменён другой программой. Перезагрузить его?</translation>
        </message>
        <message>
            <source>Keep mine</source>
            <translation>Оставить мою</translation>
        </message>
        <message>
            <source>This is recovered work of %1. It is not saved yet.</source>
            <translation>Это восстановленная работа от %1. Она ещё не сохранена.</translation>
        </message>
        <message>
            <source>This is recovered work of %1 on “%2”. It is not saved yet; the file is unchanged.</source>
            <translation>Это восстановленная работа от %1 над «%2». Она ещё не сохранена; сам файл прежний.</translation>
        </message>
        <message>
            <source>The settings file was damaged and is kept as %1. Settings that could not be read have their default values.</source>
            <translation>Файл настроек был повреждён и сохранён как %1. Настройки, которые не удалось прочитать, имеют значения по умолчанию.</translation>
        </message>
        <message>
            <source>The settings were not kept. %1</source>
            <translation>Настройки не сохранены. %1</translation>
        </message>
        <message>
            <source>The settings file is damaged and could not be renamed (%1): %2. It is left unchanged; the default settings are used, and changes to them are not saved.</source>
            <translation>Файл настроек повреждён, и убрать его в сторону не удалось (%1): %2. Он оставлен как есть; действуют настройки по умолчанию, их изменения не сохраняются.</translation>
        </message>
        <message>
            <source>The settings are the default ones: %1</source>
            <translation>Действуют настройки по умолчанию: %1</translation>
        </message>
        <message>
            <source>Unsaved work is not protected from a crash: %1</source>
            <translation>Несохранённая работа не защищена от сбоя: %1</translation>
        </message>
    </context>
    <context>
        <name>WorkRecovery</name>
        <message>
            <source>Recover work</source>
            <translation>Восстановление работы</translation>
        </message>
        <message>
            <source>No unsaved work was found.</source>
            <translation>Несохранённой работы не найдено.</translation>
        </message>
        <message>
            <source>The file was not opened</source>
            <translation>Файл не открыт</translation>
        </message>
        <message>
            <source>“%1” is damaged.</source>
            <translation>«%1» повреждён.</translation>
        </message>
        <message>
            <source>Another window has recovered this work meanwhile.</source>
            <translation>Эта работа тем временем восстановлена в другом окне.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FormRow</name>
        <message>
            <source>Stock on diameter</source>
            <translation>Припуск на диаметр</translation>
        </message>
        <message>
            <source>empty: %1</source>
            <translation>пусто: %1</translation>
        </message>
        <message>
            <source>%1, %2</source>
            <translation>%1, %2</translation>
        </message>
    </context>
    <context>
        <name>FoundTable</name>
        <message>
            <source>The quickest of its number of stages</source>
            <translation>Самый быстрый для своего числа ступеней</translation>
        </message>
        <message>
            <source>The best so far when it was found</source>
            <translation>Лучший на тот момент, когда найден</translation>
        </message>
        <message>
            <source>Stages</source>
            <translation>Ступени</translation>
        </message>
        <message>
            <source>Against yours, %</source>
            <translation>К вашему, %</translation>
        </message>
        <message>
            <source>Excess, %</source>
            <translation>Превышение, %</translation>
        </message>
        <message>
            <source>Margin, %</source>
            <translation>Запас, %</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Цикл</translation>
        </message>
        <message>
            <source>Number of stages</source>
            <translation>Число ступеней</translation>
        </message>
        <message>
            <source>Machining time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>Compared with the time of your cycle: the current one, or the one that a found cycle replaced</source>
            <translation>По сравнению с временем вашего цикла: текущего или того, который заменил найденный</translation>
        </message>
        <message>
            <source>Maximum time by which a stepless cycle might be quicker</source>
            <translation>На сколько, самое большее, может быть быстрее бесступенчатый цикл</translation>
        </message>
        <message>
            <source>The minimum margin of all requirements, relative to its limit</source>
            <translation>Наименьший запас из всех требований, в долях предела</translation>
        </message>
        <message>
            <source>The quickest of the grid</source>
            <translation>Самый быстрый в сетке</translation>
        </message>
        <message>
            <source>None is both quicker and farther from its limits</source>
            <translation>Нет цикла и быстрее, и дальше от пределов</translation>
        </message>
        <message>
            <source>Between the levels of the grid, not proved</source>
            <translation>Между уровнями сетки, не доказано</translation>
        </message>
        <message>
            <source>The farthest of the grid from its limits within the time given</source>
            <translation>Дальше всех в сетке от пределов за заданное время</translation>
        </message>
        <message>
            <source>The farthest of its number of stages from its limits, within the time</source>
            <translation>Дальше всех от пределов для своего числа ступеней, за заданное время</translation>
        </message>
        <message>
            <source>The cheapest of the grid</source>
            <translation>Самый дешёвый из сетки</translation>
        </message>
        <message>
            <source>The cheapest of its number of stages</source>
            <translation>Самый дешёвый для своего числа ступеней</translation>
        </message>
        <message>
            <source>The cycle of the grid with the longest wheel life</source>
            <translation>Тот из сетки, с которым круг работает дольше всего</translation>
        </message>
        <message>
            <source>The cycle of its number of stages with the longest wheel life</source>
            <translation>Для своего числа ступеней — тот, с которым круг работает дольше всего</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Детали</translation>
        </message>
        <message>
            <source>Cost</source>
            <translation>Стоимость</translation>
        </message>
        <message>
            <source>Parts from one dressing to the next for which it is fit</source>
            <translation>Для скольких деталей от правки до правки он годен</translation>
        </message>
        <message>
            <source>Cost of a part with its share of the dressing</source>
            <translation>Стоимость детали с её долей правки</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>Against
yours, %</source>
            <translation>К вашему,
%</translation>
        </message>
        <message>
            <source>Maximum margin</source>
            <translation>Наибольший запас</translation>
        </message>
        <message>
            <source>Minimum cost</source>
            <translation>Наименьшая стоимость</translation>
        </message>
        <message>
            <source>Longest life</source>
            <translation>Наибольшая стойкость</translation>
        </message>
        <message>
            <source>Robust answer</source>
            <translation>Надёжный цикл</translation>
        </message>
        <message>
            <source>Quickest cycle</source>
            <translation>Самый быстрый</translation>
        </message>
        <message>
            <source>Cycle found</source>
            <translation>Найденный цикл</translation>
        </message>
        <message>
            <source>the largest within %1 min, proved: %2</source>
            <translation>наибольший за %1 мин, доказано (%2)</translation>
        </message>
        <message>
            <source>the largest so far; within %1 min there may be a larger one</source>
            <translation>наибольший из найденных; за %1 мин возможен и больший</translation>
        </message>
        <message>
            <source>%1, a heuristic: a quicker cycle may be fit, too</source>
            <translation>%1, эвристика: требования может выполнять и более быстрый цикл</translation>
        </message>
        <message>
            <source>the best so far</source>
            <translation>лучший из найденных</translation>
        </message>
        <message>
            <source>none is cheaper, proved: %1</source>
            <translation>дешевле нет, доказано (%1)</translation>
        </message>
        <message>
            <source>none is fit for more parts, proved: %1</source>
            <translation>для большего числа деталей не годен ни один, доказано (%1)</translation>
        </message>
        <message>
            <source>proved for the part, the scenarios added (%1) and the required Ppk: none of %2 is quicker</source>
            <translation>быстрее нет: доказано для детали, добавленных сценариев (%1) и требуемого Ppk; %2</translation>
        </message>
        <message>
            <source>proved for the part and the scenarios added (%1): none of %2 is quicker</source>
            <translation>быстрее нет: доказано для детали и добавленных сценариев (%1); %2</translation>
        </message>
        <message>
            <source>none is quicker, proved: %1</source>
            <translation>быстрее нет, доказано (%1)</translation>
        </message>
        <message>
            <source>the wear of the wheel is not given</source>
            <translation>износ круга не задан</translation>
        </message>
        <message>
            <source>%1 a part on average</source>
            <translation>в среднем %1 на деталь</translation>
        </message>
        <message>
            <source>the next part does not meet: %1</source>
            <translation>следующая деталь нарушит: %1</translation>
        </message>
        <message>
            <source>the next part does not reach its size</source>
            <translation>следующая деталь не достигает размера</translation>
        </message>
        <message>
            <source>scenarios added: %1</source>
            <translation>добавлено сценариев: %1</translation>
        </message>
        <message>
            <source>decided for every stock of %1…%2 mm, also at %3 corners of the batch</source>
            <translation>годен для всех припусков %1…%2 мм, также при крайних сочетаниях партии (%3), решено точно</translation>
        </message>
        <message>
            <source>decided for every stock of %1…%2 mm</source>
            <translation>годен для всех припусков %1…%2 мм, решено точно</translation>
        </message>
        <message>
            <source>fit for %1 random stocks, cycle no. %2 tried</source>
            <translation>годен для %1 случайных припусков, проверен %2-м</translation>
        </message>
        <message>
            <source>all %1 random parts are good, cycle no. %2 tried</source>
            <translation>из %1 случайных деталей все годны, проверен %2-м</translation>
        </message>
        <message>
            <source>Ppk at least %1</source>
            <translation>Ppk не ниже %1</translation>
        </message>
        <message>
            <source>Ppk at least %1, too low for the batch: no cycle found meets it</source>
            <translation>Ppk не ниже %1, для партии мало: цикла с достаточным не найдено</translation>
        </message>
        <message>
            <source>continuous infeed up to %1 mm/min</source>
            <translation>непрерывная подача до %1 мм/мин</translation>
        </message>
        <message>
            <source>no continuous infeed</source>
            <translation>без непрерывной подачи</translation>
        </message>
        <message>
            <source>the wheel head may retract</source>
            <translation>с отводом шлифовальной бабки</translation>
        </message>
        <message>
            <source>the wheel head never retracts</source>
            <translation>без отвода шлифовальной бабки</translation>
        </message>
        <message>
            <source>ends at size or by a count of steps without feed</source>
            <translation>конец по размеру или по числу ходов без подачи</translation>
        </message>
        <message>
            <source>ends at size</source>
            <translation>конец по размеру</translation>
        </message>
        <message>
            <source>Bound of the grid</source>
            <translation>Граница сетки</translation>
        </message>
        <message>
            <source>none is quicker</source>
            <translation>быстрее нет</translation>
        </message>
        <message>
            <source>none is cheaper</source>
            <translation>дешевле нет</translation>
        </message>
        <message>
            <source>none is fit for more parts</source>
            <translation>для большего числа деталей не годен ни один</translation>
        </message>
        <message>
            <source>Your cycle</source>
            <translation>Ваш цикл</translation>
        </message>
        <message>
            <source>Nominal part</source>
            <translation>Номинал</translation>
        </message>
        <message>
            <source>robustness costs %1 % of time</source>
            <translation>надёжность стоит %1 % времени</translation>
        </message>
        <message>
            <source>Between levels</source>
            <translation>Между уровнями</translation>
        </message>
        <message>
            <source>not proved to be the quickest</source>
            <translation>не доказано, что самый быстрый</translation>
        </message>
        <message>
            <source>nothing quicker was found</source>
            <translation>ничего быстрее не найдено</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>Предел</translation>
        </message>
        <message>
            <source>a stepless cycle</source>
            <translation>бесступенчатый цикл</translation>
        </message>
        <message>
            <source>Unfit for
stocks, ≤ %</source>
            <translation>Не годен для
припусков, ≤ %</translation>
        </message>
        <message>
            <source>Unfit for stocks, at most, %</source>
            <translation>Не годен для припусков, не более, %</translation>
        </message>
        <message>
            <source>Share of the stocks within one infeed for which the cycle may be unfit, with 95 % confidence: it was fit for all those tried</source>
            <translation>Доля припусков в пределах подачи на шаг, для которых цикл может быть не годен, с доверительной вероятностью 95 %: для всех проверенных он годен</translation>
        </message>
        <message>
            <source>Rejected
parts, ≤ %</source>
            <translation>Негодные
детали, ≤ %</translation>
        </message>
        <message>
            <source>Rejected parts, at most, %</source>
            <translation>Негодные детали, не более, %</translation>
        </message>
        <message>
            <source>Share of the batch that may be rejected, with 95 % confidence: all parts tried were good</source>
            <translation>Доля деталей партии, которые могут быть не годны, с доверительной вероятностью 95 %: все проверенные годны</translation>
        </message>
        <message>
            <source>Basis</source>
            <translation>Основание</translation>
        </message>
        <message>
            <source>proved</source>
            <translation>доказано</translation>
        </message>
        <message>
            <source>a heuristic</source>
            <translation>эвристика</translation>
        </message>
        <message>
            <source>not proved</source>
            <translation>не доказано</translation>
        </message>
        <message>
            <source>%1 random stocks</source>
            <translation>%1 случ. припусков</translation>
        </message>
        <message>
            <source>every stock and corner</source>
            <translation>припуски и сочетания</translation>
        </message>
        <message>
            <source>every stock</source>
            <translation>все припуски</translation>
        </message>
        <message>
            <source>parts good</source>
            <translation>детали годны</translation>
        </message>
        <message>
            <source>The tool tip of a cell has the whole text</source>
            <translation>Весь текст — в подсказке ячейки</translation>
        </message>
        <message>
            <source>%1, too low</source>
            <comment>Ppk</comment>
            <translation>%1, мало</translation>
        </message>
    </context>
    <context>
        <name>sparkout::HandoutDialog</name>
        <message>
            <source>&amp;Answers to the questions, on a last page</source>
            <translation>&amp;Ответы на вопросы на последней странице</translation>
        </message>
        <message>
            <source>Course hand-out</source>
            <translation>Раздаточный материал</translation>
        </message>
        <message>
            <source>&amp;Step that is worked out:</source>
            <translation>Разбираемый &amp;шаг:</translation>
        </message>
        <message>
            <source>Step that is worked out</source>
            <translation>Разбираемый шаг</translation>
        </message>
        <message>
            <source>Charts</source>
            <translation>Графики</translation>
        </message>
        <message>
            <source>&amp;Continue</source>
            <translation>&amp;Продолжить</translation>
        </message>
        <message>
            <source>Cance&amp;l</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>%1, revolution %2</source>
            <translation>%1, оборот %2</translation>
        </message>
        <message>
            <source>Current moment of the cycle: %1, k = %2</source>
            <translation>Текущий момент цикла: %1, k = %2</translation>
        </message>
        <message>
            <source>The deepest cut of a stage: %1, k = %2</source>
            <translation>Наибольшая подача ступени: %1, k = %2</translation>
        </message>
        <message>
            <source>The deepest cut of the cycle: %1, k = %2</source>
            <translation>Наибольшая подача цикла: %1, k = %2</translation>
        </message>
        <message>
            <source>&amp;Contents:</source>
            <translation>&amp;Что печатается:</translation>
        </message>
        <message>
            <source>Contents of the handout</source>
            <translation>Что печатается</translation>
        </message>
        <message>
            <source>Hand-out with its results</source>
            <translation>Раздаточный материал с результатами</translation>
        </message>
        <message>
            <source>Worksheet: results are left empty</source>
            <translation>Рабочий лист: результаты впишет студент</translation>
        </message>
        <message>
            <source>Key to the worksheet</source>
            <translation>Ключ к рабочему листу</translation>
        </message>
    </context>
    <context>
        <name>sparkout::HelpWindow</name>
        <message>
            <source>Back</source>
            <translation>Назад</translation>
        </message>
        <message>
            <source>Forward</source>
            <translation>Вперёд</translation>
        </message>
        <message>
            <source>Search the help (Ctrl+F)</source>
            <translation>Поиск по справке (Ctrl+F)</translation>
        </message>
        <message>
            <source>Search the help</source>
            <translation>Поиск по справке</translation>
        </message>
        <message>
            <source>Contents</source>
            <translation>Содержание</translation>
        </message>
        <message>
            <source>Page of the help</source>
            <translation>Страница справки</translation>
        </message>
        <message>
            <source>No page has all these words.</source>
            <translation>Ни на одной странице нет всех этих слов.</translation>
        </message>
        <message>
            <source>%1 — Sparkout help</source>
            <translation>%1 — справка Sparkout</translation>
        </message>
        <message>
            <source>Sparkout help</source>
            <translation>Справка Sparkout</translation>
        </message>
    </context>
    <context>
        <name>sparkout::HintStrip</name>
        <message>
            <source>Help on the selected input appears here.</source>
            <translation>Здесь поясняется поле, в котором стоит курсор, и его пределы.</translation>
        </message>
        <message>
            <source>About the input in focus</source>
            <translation>О выбранном поле</translation>
        </message>
    </context>
    <context>
        <name>sparkout::InputBox</name>
        <message>
            <source>%1: %2</source>
            <comment>input: number</comment>
            <translation>%1: %2</translation>
        </message>
    </context>
    <context>
        <name>sparkout::InputsPanel</name>
        <message>
            <source>Part</source>
            <translation>Деталь</translation>
        </message>
        <message>
            <source>Material</source>
            <translation>Материал</translation>
        </message>
        <message>
            <source>Wheel</source>
            <translation>Круг</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Станок</translation>
        </message>
        <message>
            <source>Gauge</source>
            <translation>ПАК</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Цикл</translation>
        </message>
        <message>
            <source>%1 (Alt+%2)</source>
            <translation>%1 (Alt+%2)</translation>
        </message>
        <message>
            <source>Batch</source>
            <translation>Партия</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>Поиск</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LayersPlot</name>
        <message>
            <source>initial radius</source>
            <translation>исходный радиус</translation>
        </message>
        <message>
            <source>final radius</source>
            <translation>конечный радиус</translation>
        </message>
        <message>
            <source>target</source>
            <translation>целевой радиус</translation>
        </message>
        <message>
            <source>tolerance band</source>
            <translation>поле допуска</translation>
        </message>
        <message>
            <source>Stage</source>
            <translation>Ступень</translation>
        </message>
        <message>
            <source>From double stroke or revolution</source>
            <translation>С двойного хода или оборота</translation>
        </message>
        <message>
            <source>To double stroke or revolution</source>
            <translation>По двойной ход или оборот</translation>
        </message>
        <message>
            <source>%1, removed, µm</source>
            <translation>%1, снято, мкм</translation>
        </message>
        <message>
            <source>%1, so far, µm</source>
            <translation>%1, всего снято, мкм</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LayersSurface</name>
        <message>
            <source>Length, mm</source>
            <translation>Длина, мм</translation>
        </message>
        <message>
            <source>Double stroke</source>
            <translation>Двойной ход</translation>
        </message>
        <message>
            <source>Revolution</source>
            <translation>Оборот</translation>
        </message>
        <message>
            <source>Accumulated actual feed, µm</source>
            <translation>Накопленная фактическая подача, мкм</translation>
        </message>
        <message>
            <source>Number of double strokes or revolutions</source>
            <translation>Число двойных ходов или оборотов</translation>
        </message>
        <message>
            <source>%1, accumulated actual feed, µm</source>
            <translation>%1, накопленная фактическая подача, мкм</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LayersView</name>
        <message>
            <source>Point at a layer to read the values.</source>
            <translation>Наведите указатель на слой, чтобы прочитать значения.</translation>
        </message>
        <message>
            <source>Layers</source>
            <translation>Слои</translation>
        </message>
        <message>
            <source>Mean of the radii</source>
            <translation>Среднее по радиусам</translation>
        </message>
        <message>
            <source>Radius %1, %2°</source>
            <translation>Радиус %1, %2°</translation>
        </message>
        <message>
            <source>Drag or press the arrow keys to turn the surface; the wheel zooms.</source>
            <translation>Поверхность поворачивают мышью или стрелками; колесо мыши меняет масштаб.</translation>
        </message>
        <message>
            <source>The inputs are refused; the layers are those of the last valid inputs.</source>
            <translation>Исходные данные не приняты; слои — по последним верным.</translation>
        </message>
        <message>
            <source>The cycle is too long to be recorded: its layers are not drawn. Fewer radii or sections help.</source>
            <translation>Цикл слишком длинный для записи: его слои не показаны. Поможет меньшее число радиусов или сечений.</translation>
        </message>
        <message>
            <source>%1: %2 µm off everywhere.</source>
            <translation>%1: всюду снято %2 мкм.</translation>
        </message>
        <message>
            <source>%1: most off %2, %3 µm; least off %4, %5 µm.</source>
            <translation>%1. Больше всего снято: %2, %3 мкм; меньше всего: %4, %5 мкм.</translation>
        </message>
        <message>
            <source>Layers of the stock along the part</source>
            <translation>Слои припуска вдоль детали</translation>
        </message>
        <message>
            <source>Accumulated actual feed over length and number</source>
            <translation>Накопленная фактическая подача по длине и номеру хода</translation>
        </message>
        <message>
            <source>Legend of the layers</source>
            <translation>Условные обозначения слоёв</translation>
        </message>
        <message>
            <source>State of the layers</source>
            <translation>Состояние слоёв</translation>
        </message>
        <message>
            <source>Accumulated removal</source>
            <translation>Накопленный съём</translation>
        </message>
        <message>
            <source>Values under the mouse</source>
            <translation>Значения под указателем</translation>
        </message>
        <message>
            <source>Stacked layers</source>
            <translation>Слои в разрезе</translation>
        </message>
        <message>
            <source>Surface</source>
            <translation>Поверхность</translation>
        </message>
        <message>
            <source>How the layers are drawn</source>
            <translation>Как показаны слои</translation>
        </message>
        <message>
            <source>Radius whose layers are drawn</source>
            <translation>Радиус, слои которого показаны</translation>
        </message>
        <message>
            <source>Wheel and part from the side, heights exaggerated</source>
            <translation>Круг и деталь сбоку, высоты увеличены</translation>
        </message>
        <message>
            <source>Wheel and part</source>
            <translation>Круг и деталь</translation>
        </message>
        <message>
            <source>Heights are exaggerated. As in the model, a zone is ground during the whole stroke; the whole deflection is drawn at the part.</source>
            <translation>Высоты увеличены. По модели зона шлифуется в течение всего хода; всё отжатие показано у детали.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LegendStrip</name>
        <message>
            <source>Click: hide or show the curve. Ctrl+click: show only this one. Keyboard: arrows, Space, Ctrl+Space.</source>
            <translation>Щелчок: скрыть или показать кривую. Ctrl+щелчок: показать только её. С клавиатуры: стрелки, пробел, Ctrl+пробел.</translation>
        </message>
        <message>
            <source>%1 (hidden)</source>
            <translation>%1 (скрыто)</translation>
        </message>
        <message>
            <source>%1 (above the plot)</source>
            <translation>%1 (выше графика)</translation>
        </message>
        <message>
            <source>chosen: %1</source>
            <translation>выбрано: %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ListModel</name>
        <message>
            <source>%1 %2, %3: %4</source>
            <translation>%1 %2, %3: %4</translation>
        </message>
        <message>
            <source>“%1” cannot be entered: this row does not use the column</source>
            <translation>«%1» не на месте: этот столбец в строке не используется</translation>
        </message>
        <message>
            <source>a number is missing; allowed: %1</source>
            <translation>нет числа; допускается: %1</translation>
        </message>
        <message>
            <source>“%2” is not a number; allowed: %1</source>
            <translation>«%2» — не число; допускается: %1</translation>
        </message>
        <message>
            <source>“%2” is not a whole number; allowed: %1</source>
            <translation>«%2» — не целое число; допускается: %1</translation>
        </message>
        <message>
            <source>“%2” is out of range; allowed: %1</source>
            <translation>«%2» вне допустимых пределов; допускается: %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ListTable</name>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>add a row</source>
            <translation>добавить строку</translation>
        </message>
        <message>
            <source>remove the row</source>
            <translation>удалить строку</translation>
        </message>
        <message>
            <source>move the row up</source>
            <translation>переместить строку вверх</translation>
        </message>
        <message>
            <source>move the row down</source>
            <translation>переместить строку вниз</translation>
        </message>
        <message>
            <source>%1 (%2)</source>
            <translation>%1 (%2)</translation>
        </message>
        <message>
            <source>Ins</source>
            <translation>Ins</translation>
        </message>
        <message>
            <source>Ctrl+Up</source>
            <translation>Ctrl+↑</translation>
        </message>
        <message>
            <source>Ctrl+Down</source>
            <translation>Ctrl+↓</translation>
        </message>
        <message>
            <source>&amp;Copy the table</source>
            <translation>&amp;Копировать таблицу</translation>
        </message>
        <message>
            <source>Ctrl+Del</source>
            <translation>Ctrl+Del</translation>
        </message>
        <message>
            <source>Not pasted: %1</source>
            <translation>Не вставлено: %1</translation>
        </message>
        <message numerus="yes">
            <source>Not pasted: %n further cell(s)</source>
            <translation>
                <numerusform>Не вставлено: ещё %n ячейка</numerusform>
                <numerusform>Не вставлено: ещё %n ячейки</numerusform>
                <numerusform>Не вставлено: ещё %n ячеек</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n further remark(s) among the messages</source>
            <translation>
                <numerusform>ещё %n замечание в сообщениях</numerusform>
                <numerusform>ещё %n замечания в сообщениях</numerusform>
                <numerusform>ещё %n замечаний в сообщениях</numerusform>
            </translation>
        </message>
        <message>
            <source>Copy the &amp;selected cells</source>
            <translation>Копировать &amp;выбранные ячейки</translation>
        </message>
        <message>
            <source>&amp;Paste</source>
            <translation>Вст&amp;авить</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LogDialog</name>
        <message>
            <source>warning: </source>
            <translation>предупреждение: </translation>
        </message>
        <message>
            <source>error: </source>
            <translation>ошибка: </translation>
        </message>
        <message>
            <source>Log of this session</source>
            <translation>Журнал этого запуска</translation>
        </message>
        <message>
            <source>C&amp;opy</source>
            <translation>&amp;Копировать</translation>
        </message>
        <message>
            <source>C&amp;lose</source>
            <translation>&amp;Закрыть</translation>
        </message>
        <message>
            <source>%1 earlier lines are no longer kept.</source>
            <translation>Более ранних строк, которые уже не хранятся: %1.</translation>
        </message>
        <message>
            <source>Nothing was reported.</source>
            <translation>Сообщений не было.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LongitudinalPlot</name>
        <message>
            <source>%1 (entry)</source>
            <translation>%1 (вход)</translation>
        </message>
        <message>
            <source>%1 (exit)</source>
            <translation>%1 (выход)</translation>
        </message>
        <message>
            <source>lower limit</source>
            <translation>нижняя граница</translation>
        </message>
        <message>
            <source>upper limit</source>
            <translation>верхняя граница</translation>
        </message>
        <message>
            <source>target</source>
            <translation>целевой радиус</translation>
        </message>
        <message>
            <source>blank, minimum</source>
            <translation>заготовка, наименьший</translation>
        </message>
        <message>
            <source>blank, maximum</source>
            <translation>заготовка, наибольший</translation>
        </message>
        <message>
            <source>minimum</source>
            <translation>наименьший</translation>
        </message>
        <message>
            <source>maximum</source>
            <translation>наибольший</translation>
        </message>
        <message>
            <source>mean</source>
            <translation>средний</translation>
        </message>
        <message>
            <source>%1, other side</source>
            <translation>%1, другая сторона</translation>
        </message>
        <message>
            <source>Radius, mm</source>
            <translation>Радиус, мм</translation>
        </message>
        <message>
            <source>Diameter from
nominal, µm</source>
            <translation>Диаметр от
номинала, мкм</translation>
        </message>
        <message>
            <source>Radius from
target, µm</source>
            <translation>Радиус от
целевого, мкм</translation>
        </message>
        <message>
            <source>to scale: one pixel is %1 µm; the tolerance of the radius, %2 µm, is %3 of it</source>
            <translation>в масштабе: один пиксель — %1 мкм; допуск радиуса %2 мкм — это %3 пикселя</translation>
        </message>
        <message>
            <source>heights exaggerated %1</source>
            <translation>высоты увеличены %1</translation>
        </message>
        <message>
            <source>From the headstock end of the ground length, mm</source>
            <translation>От начала шлифуемой длины со стороны передней бабки, мм</translation>
        </message>
        <message>
            <source>%1; %2</source>
            <translation>%1; %2</translation>
        </message>
        <message>
            <source>From the headstock end, mm</source>
            <translation>От конца у передней бабки, мм</translation>
        </message>
        <message>
            <source>%1, mm</source>
            <translation>%1, мм</translation>
        </message>
        <message>
            <source>%1, µm</source>
            <translation>%1, мкм</translation>
        </message>
    </context>
    <context>
        <name>sparkout::MainWindow</name>
        <message>
            <source>The logo in the heads of documents is left out. %1</source>
            <translation>Логотип в заголовках документов не печатается. %1</translation>
        </message>
        <message>
            <source>Company and signatures…</source>
            <translation>Предприятие и подписи…</translation>
        </message>
        <message>
            <source>%1: ended.</source>
            <translation>%1: расчёт окончен.</translation>
        </message>
        <message>
            <source>Saved.</source>
            <translation>Сохранено.</translation>
        </message>
        <message numerus="yes">
            <source>Saved. %n fields contain invalid entries; their last valid values were saved.</source>
            <translation>
                <numerusform>Сохранено; %n поле содержит непринятый текст, записано его последнее верное значение.</numerusform>
                <numerusform>Сохранено; %n поля содержат непринятый текст, записаны их последние верные значения.</numerusform>
                <numerusform>Сохранено; %n полей содержат непринятый текст, записаны их последние верные значения.</numerusform>
            </translation>
        </message>
        <message>
            <source>Untitled</source>
            <translation>Без имени</translation>
        </message>
        <message>
            <source>%1 (not saved)</source>
            <translation>%1 (не сохранён)</translation>
        </message>
        <message>
            <source>%1[*] — Sparkout</source>
            <translation>%1[*] — Sparkout</translation>
        </message>
        <message>
            <source>%1[*] (read-only) — Sparkout</source>
            <translation>%1[*] (только чтение) — Sparkout</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
    </context>
    <context>
        <name>sparkout::RunBar</name>
        <message>
            <source>%1, %2 s left</source>
            <translation>%1, осталось %2 с</translation>
        </message>
        <message>
            <source>%1, %2 min left</source>
            <translation>%1, осталось %2 мин</translation>
        </message>
    </context>
    <context>
        <name>sparkout::WindowLayout</name>
        <message>
            <source>Detach or attach the panel</source>
            <translation>Отделить или вернуть панель</translation>
        </message>
        <message>
            <source>Close the panel</source>
            <translation>Закрыть панель</translation>
        </message>
        <message>
            <source>More commands</source>
            <translation>Другие команды</translation>
        </message>
        <message>
            <source>More menus</source>
            <translation>Другие меню</translation>
        </message>
        <message>
            <source>Scroll to the left</source>
            <translation>Прокрутить влево</translation>
        </message>
        <message>
            <source>Scroll to the right</source>
            <translation>Прокрутить вправо</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Исходные данные</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>Сообщения</translation>
        </message>
        <message>
            <source>Formulas of the step</source>
            <translation>Формулы этапа</translation>
        </message>
        <message>
            <source>Laboratory work</source>
            <translation>Лабораторная работа</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StatusLine</name>
        <message numerus="yes">
            <source>Not computed: %n faults in the inputs. The curves show the last good run.</source>
            <translation>
                <numerusform>Не рассчитано: %n ошибка в исходных данных. Показаны кривые последнего удачного расчёта.</numerusform>
                <numerusform>Не рассчитано: %n ошибки в исходных данных. Показаны кривые последнего удачного расчёта.</numerusform>
                <numerusform>Не рассчитано: %n ошибок в исходных данных. Показаны кривые последнего удачного расчёта.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Not computed: %n faults in the inputs.</source>
            <translation>
                <numerusform>Не рассчитано: %n ошибка в исходных данных.</numerusform>
                <numerusform>Не рассчитано: %n ошибки в исходных данных.</numerusform>
                <numerusform>Не рассчитано: %n ошибок в исходных данных.</numerusform>
            </translation>
        </message>
        <message>
            <source>The cycle is complete.</source>
            <translation>Цикл завершён.</translation>
        </message>
        <message>
            <source>The cycle cannot reach size: it stopped making progress.</source>
            <translation>Цикл не достигает размера: съём прекратился.</translation>
        </message>
        <message>
            <source>The cycle is too long to be computed to its end.</source>
            <translation>Цикл слишком длинный, чтобы рассчитать его до конца.</translation>
        </message>
        <message>
            <source>The forces of the coupled sections were not found.</source>
            <translation>Силы в связанных сечениях не найдены.</translation>
        </message>
        <message>
            <source>The compliance of a section is negative: the even load beyond a steady rest presses it against the wheel. Couple the sections.</source>
            <translation>Податливость одного из сечений отрицательна: равномерная нагрузка за люнетом прижимает его к кругу. Свяжите сечения.</translation>
        </message>
        <message>
            <source>Computed in %1 ms</source>
            <translation>Расчёт за %1 мс</translation>
        </message>
        <message>
            <source>Status</source>
            <translation>Состояние</translation>
        </message>
        <message>
            <source>Computing time</source>
            <translation>Время расчёта</translation>
        </message>
        <message>
            <source>Not computed: the project is not complete.</source>
            <translation>Не рассчитано: проект не заполнен.</translation>
        </message>
        <message>
            <source>One infeed is larger than the part: reduce the feed.</source>
            <translation>Подача на шаг больше размера детали: уменьшите подачу.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::MarginModel</name>
        <message>
            <source>%1, %2 used, %3: %4</source>
            <translation>%1; использовано %2; %3: %4</translation>
        </message>
        <message>
            <source>Requirement</source>
            <translation>Требование</translation>
        </message>
        <message>
            <source>Used up</source>
            <translation>Занято</translation>
        </message>
        <message>
            <source>Value / limit</source>
            <translation>Значение / предел</translation>
        </message>
        <message>
            <source>Used up, %</source>
            <translation>Занято, %</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>Предел</translation>
        </message>
        <message>
            <source>Margin</source>
            <translation>Запас</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>%1, range %2…%3 %4</source>
            <translation>%1, диапазон %2…%3 %4</translation>
        </message>
        <message>
            <source>%1, %2, %3: %4</source>
            <translation>%1; %2; %3: %4</translation>
        </message>
        <message>
            <source>Setting / nearer end of the range</source>
            <translation>Настройка / ближний предел диапазона</translation>
        </message>
    </context>
    <context>
        <name>sparkout::MarkingHelper</name>
        <message>
            <source>To fill in: %1.</source>
            <translation>Будет заполнено: %1.</translation>
        </message>
        <message>
            <source>The machine&apos;s wheel speed is above what the marking allows.</source>
            <translation>Скорость круга на станке выше допускаемой маркировкой.</translation>
        </message>
        <message>
            <source>This is not a marking. Write it like 500×50×203 25А F60 L 6 V 35 to fill in the wheel&apos;s values.</source>
            <translation>Не понято как маркировка; записанная как 500×50×203 25А F60 L 6 V 35, она заполняет данные круга.</translation>
        </message>
        <message>
            <source>Meaning of the marking</source>
            <translation>Что значит маркировка</translation>
        </message>
        <message>
            <source>Fill in from the marking</source>
            <translation>Заполнить по маркировке</translation>
        </message>
        <message>
            <source>Sets grain, grain share and sizes as far as the marking states them</source>
            <translation>Задать зерно, долю зерна и размеры по маркировке</translation>
        </message>
    </context>
    <context>
        <name>sparkout::MessagesDock</name>
        <message>
            <source>No messages</source>
            <translation>Сообщений нет</translation>
        </message>
        <message numerus="yes">
            <source>%n message(s)</source>
            <translation>
                <numerusform>%n сообщение</numerusform>
                <numerusform>%n сообщения</numerusform>
                <numerusform>%n сообщений</numerusform>
            </translation>
        </message>
        <message>
            <source>Show or hide the messages</source>
            <translation>Показать или скрыть сообщения</translation>
        </message>
    </context>
    <context>
        <name>sparkout::MessagesPanel</name>
        <message>
            <source>%1; the last good value is used</source>
            <translation>%1; используется последнее верное значение</translation>
        </message>
        <message>
            <source>No messages: all inputs are in order.</source>
            <translation>Замечаний нет: исходные данные в порядке.</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Double-click to go to the field</source>
            <translation>Двойной щелчок — перейти к полю</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>Сообщения</translation>
        </message>
        <message>
            <source>Fit the stocks of the stages</source>
            <translation>Согласовать припуски ступеней</translation>
        </message>
        <message>
            <source>The first stage takes the stock that the later ones leave; if they leave none, all keep their share</source>
            <translation>Первая ступень снимает припуск, оставшийся от последующих; если его не остаётся, все ступени сохраняют свои доли</translation>
        </message>
    </context>
    <context>
        <name>sparkout::NotesEditor</name>
        <message>
            <source>the text takes %1 KB; at most %2 KB are kept</source>
            <translation>текст занимает %1 КБ; сохраняется не более %2 КБ</translation>
        </message>
    </context>
    <context>
        <name>sparkout::NoticeBar</name>
        <message>
            <source>Notice</source>
            <translation>Извещение</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Закрыть</translation>
        </message>
    </context>
    <context>
        <name>sparkout::NumberEditor</name>
        <message>
            <source>%1, slider</source>
            <translation>%1, ползунок</translation>
        </message>
    </context>
    <context>
        <name>sparkout::NumberField</name>
        <message>
            <source>a number is needed here</source>
            <translation>здесь нужно число</translation>
        </message>
        <message>
            <source>“%1” is not a number</source>
            <translation>«%1» — не число</translation>
        </message>
        <message>
            <source>a whole number is needed here</source>
            <translation>здесь нужно целое число</translation>
        </message>
        <message>
            <source>out of range; allowed: %1</source>
            <translation>вне допустимых значений; допускается: %1</translation>
        </message>
        <message>
            <source>unusual; usual: %1</source>
            <translation>необычное значение; обычно: %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::NumberLines</name>
        <message>
            <source>%1, slider</source>
            <translation>%1, ползунок</translation>
        </message>
        <message>
            <source>Not pasted: %1</source>
            <translation>Не вставлено: %1</translation>
        </message>
        <message numerus="yes">
            <source>%n cell(s) too many</source>
            <translation>
                <numerusform>лишняя %n ячейка</numerusform>
                <numerusform>лишние %n ячейки</numerusform>
                <numerusform>лишних %n ячеек</numerusform>
            </translation>
        </message>
        <message>
            <source>%1: %2</source>
            <comment>label of a number: reason</comment>
            <translation>%1: %2</translation>
        </message>
    </context>
    <context>
        <name>sparkout::NumbersEditor</name>
        <message>
            <source>%1…%2 step %3</source>
            <translation>%1…%2 шаг %3</translation>
        </message>
        <message>
            <source>values separated by semicolons, as in 300; 500; 800, or from, to and step, as in 300…2400 step 100</source>
            <translation>значения через точку с запятой, например 300; 500; 800, или пределы и шаг, например 300…2400 шаг 100</translation>
        </message>
        <message numerus="yes">
            <source>%n number(s) separated by semicolons</source>
            <translation>
                <numerusform>%n число через точку с запятой</numerusform>
                <numerusform>%n числа через точку с запятой</numerusform>
                <numerusform>%n чисел через точку с запятой</numerusform>
            </translation>
        </message>
        <message>
            <source>numbers separated by semicolons, as in 1; 2; 3</source>
            <translation>числа через точку с запятой, например 1; 2; 3</translation>
        </message>
        <message>
            <source>the second value is below the first</source>
            <translation>второе значение меньше первого</translation>
        </message>
        <message>
            <source>%1; allowed: %2</source>
            <translation>%1; допускается: %2</translation>
        </message>
        <message>
            <source>these values contradict the other inputs</source>
            <translation>остальные данные не сочетаются с этими значениями</translation>
        </message>
    </context>
    <context>
        <name>sparkout::OfferHelper</name>
        <message>
            <source>Purpose of a batch</source>
            <translation>Для чего партия</translation>
        </message>
        <message>
            <source>A batch shows which share of many parts meets the drawing when stock, runout, dullness and other factors scatter. The view Batch runs it.</source>
            <translation>Партия показывает, какая доля многих деталей выдерживает чертёж, когда припуск, биение, затупление и другие факторы рассеиваются. Её рассчитывает вид «Партия».</translation>
        </message>
        <message>
            <source>Add a typical batch</source>
            <translation>Добавить типовую партию</translation>
        </message>
        <message>
            <source>50 parts whose stock, runout and dullness scatter about the current inputs</source>
            <translation>50 деталей, у которых припуск, биение и затупление рассеиваются вокруг текущих значений</translation>
        </message>
        <message>
            <source>Purpose of a search</source>
            <translation>Для чего нужен поиск</translation>
        </message>
        <message>
            <source>A search finds the quickest cycle that meets every requirement, among all feeds and stocks listed here. The view Optimise runs it.</source>
            <translation>Поиск находит самый быстрый цикл, который выдерживает все требования, среди всех перечисленных здесь подач и припусков. Его запускает вид «Оптимизация».</translation>
        </message>
        <message>
            <source>Add a typical search</source>
            <translation>Добавить типовой поиск</translation>
        </message>
        <message>
            <source>The mass by the steps of the shaft</source>
            <translation>Масса по ступеням вала</translation>
        </message>
        <message>
            <source>By the steps of the shaft, as solid steel of 7850 kg/m³: about %1 kg. An estimate.</source>
            <translation>По ступеням вала, сплошная сталь 7850 кг/м³: около %1 кг. Оценка.</translation>
        </message>
        <message>
            <source>Apply the estimate</source>
            <translation>Применить оценку</translation>
        </message>
        <message>
            <source>Without chamfers, keyways and bores; the mass in the drawing takes precedence</source>
            <translation>Без фасок, пазов и отверстий; масса по чертежу важнее</translation>
        </message>
        <message>
            <source>Levels of each feed about the current cycle in steps of the machine, stocks, spark-out, and the usual minimum overlap and steps of a stage where none are given; the answer is fit for the batch, or without one for every stock</source>
            <translation>Уровни каждой подачи около текущего цикла с шагом станка, припуски, выхаживание и, если не заданы, обычные наименьшие коэффициент перекрытия и число шагов ступени; ответ годен для партии, без неё — для всех припусков</translation>
        </message>
        <message>
            <source>The machine&apos;s form by the measured parts</source>
            <translation>Форма от станка по измеренным деталям</translation>
        </message>
        <message>
            <source>Measured by zone or section, mean in µm: roundness and radial runout %1. The number of lobes was not measured.</source>
            <translation>Измерено по зонам или сечениям, среднее в мкм: отклонение от круглости и радиальное биение %1. Число граней не измерялось.</translation>
        </message>
        <message>
            <source>Apply it as the machine&apos;s form</source>
            <translation>Задать форму от станка</translation>
        </message>
        <message>
            <source>In a cycle with spark-out, the form left by the process itself is small in comparison; the number of lobes must be entered</source>
            <translation>После выхаживания вклад самого процесса рядом с ней мал; число граней нужно задать</translation>
        </message>
    </context>
    <context>
        <name>sparkout::OptimiseView</name>
        <message>
            <source>Optimise</source>
            <translation>Оптимизация</translation>
        </message>
        <message>
            <source>Your cycle</source>
            <translation>Ваш цикл</translation>
        </message>
        <message>
            <source>Cycle found</source>
            <translation>Найденный цикл</translation>
        </message>
        <message>
            <source>Point at a curve to read its values beside those of your cycle.</source>
            <translation>Наведите указатель на кривую, чтобы прочитать её значения рядом со значениями вашего цикла.</translation>
        </message>
        <message>
            <source>Point at a number of stages to read its time.</source>
            <translation>Наведите указатель на число ступеней, чтобы прочитать время.</translation>
        </message>
        <message>
            <source>The inputs are refused; the search is that of the last valid inputs.</source>
            <translation>Данные не приняты; поиск — по последним верным.</translation>
        </message>
        <message>
            <source>This project defines no search. A search tries every listed feed and stock of the stages and finds the quickest cycle that meets every requirement. Choose them on the page Search of the inputs, or start with typical ones.</source>
            <translation>В проекте не задано, что можно менять. Поиск перебирает заданные подачи и припуски ступеней и находит самый быстрый цикл, который выдерживает все требования. Задайте их на странице «Поиск» исходных данных или начните с типовых.</translation>
        </message>
        <message>
            <source>“Search” finds the quickest cycle of the grid that meets every requirement. It can be stopped at any time and keeps the best so far.</source>
            <translation>«Найти» ищет самый быстрый цикл сетки, который выдерживает все требования. Поиск можно остановить в любой момент, лучший найденный цикл сохранится.</translation>
        </message>
        <message>
            <source>Feeds and radii of your cycle and of the one found</source>
            <translation>Подачи и радиусы вашего и найденного циклов</translation>
        </message>
        <message>
            <source>Machining time over the number of stages</source>
            <translation>Основное время в зависимости от числа ступеней</translation>
        </message>
        <message>
            <source>Legend of the search</source>
            <translation>Условные обозначения поиска</translation>
        </message>
        <message>
            <source>Result of the search</source>
            <translation>Что нашёл поиск</translation>
        </message>
        <message>
            <source>Size of the grid</source>
            <translation>Размер сетки</translation>
        </message>
        <message>
            <source>Values under the mouse</source>
            <translation>Значения под указателем</translation>
        </message>
        <message>
            <source>Progress of the search</source>
            <translation>Ход поиска</translation>
        </message>
        <message>
            <source>The best cycles found</source>
            <translation>Лучшие найденные циклы</translation>
        </message>
        <message>
            <source>Before and after</source>
            <translation>До и после</translation>
        </message>
        <message>
            <source>Time by stages</source>
            <translation>Время по числу ступеней</translation>
        </message>
        <message>
            <source>Displayed results of the search</source>
            <translation>Что показать из поиска</translation>
        </message>
        <message>
            <source>Zone or section of the curves</source>
            <translation>Зона или сечение кривых</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>Найти</translation>
        </message>
        <message>
            <source>Find the quickest cycle of the grid that meets every requirement</source>
            <translation>Найти самый быстрый цикл сетки, который выдерживает все требования</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Остановить</translation>
        </message>
        <message>
            <source>Stop the search; the best so far is kept and shown</source>
            <translation>Закончить поиск; лучший найденный цикл сохраняется и показывается</translation>
        </message>
        <message>
            <source>Apply this cycle</source>
            <translation>Применить этот цикл</translation>
        </message>
        <message>
            <source>Replaces the current cycle with the chosen one; undo restores yours</source>
            <translation>Поставить выбранный цикл на место текущего; отмена вернёт ваш</translation>
        </message>
        <message>
            <source>For every stock</source>
            <translation>Для всех припусков</translation>
        </message>
        <message>
            <source>The cycle must also be fit for stocks spread over one feed step of every stage: the size depends on the position of the last step</source>
            <translation>Цикл должен быть годен для всех припусков в пределах подачи на шаг каждой ступени: размер зависит от того, куда пришёлся последний шаг</translation>
        </message>
        <message>
            <source>Add a typical search</source>
            <translation>Добавить типовой поиск</translation>
        </message>
        <message>
            <source>Between levels</source>
            <translation>Между уровнями</translation>
        </message>
        <message>
            <source>Continue from the quickest cycle between the levels of the grid, in the machine&apos;s steps: every cycle is run in full, but the result is not proved to be the quickest</source>
            <translation>Искать дальше от самого быстрого цикла между уровнями сетки, с дискретностью станка: каждый цикл просчитывается целиком, но что быстрее нет, не доказывается</translation>
        </message>
        <message>
            <source>The inputs are refused; the grid is that of the last valid inputs.</source>
            <translation>Исходные данные не приняты; сетка — по последним верным.</translation>
        </message>
        <message>
            <source>Grid of dynamic programming</source>
            <translation>Сетка динамического программирования</translation>
        </message>
        <message>
            <source>Maximum margin over the machining time; the table below lists its cycles</source>
            <translation>Наибольший запас в зависимости от основного времени; циклы перечислены в таблице ниже</translation>
        </message>
        <message>
            <source>Margin by time</source>
            <translation>Запас по времени</translation>
        </message>
        <message>
            <source>“Search” finds the cycle of the grid farthest from its limits within the time given. It can be stopped at any time and keeps the best so far.</source>
            <translation>«Найти» находит цикл сетки, который за заданное время дальше всех от пределов. Поиск можно остановить в любой момент, лучшее найденное остаётся.</translation>
        </message>
        <message>
            <source>Levels of each feed about the current cycle in steps of the machine, stocks, spark-out, and the usual minimum overlap and steps of a stage where none are given; the answer is fit for the batch, or without one for every stock; can be undone and changed on the pages Search and Cycle</source>
            <translation>Уровни каждой подачи около текущего цикла с шагом станка, припуски, выхаживание и, если не заданы, обычные наименьшие коэффициент перекрытия и число шагов ступени; ответ годен для партии, без неё — для всех припусков; можно отменить и изменить на страницах «Поиск» и «Цикл»</translation>
        </message>
        <message>
            <source>A click or the arrow keys choose a cycle, “Apply this cycle” or Enter applies it.</source>
            <translation>Щелчок или стрелки выбирают цикл, «Применить этот цикл» или Enter применяет его.</translation>
        </message>
        <message>
            <source>Method of the search</source>
            <translation>Метод поиска</translation>
        </message>
        <message>
            <source>Continue</source>
            <translation>Продолжить</translation>
        </message>
        <message>
            <source>Continue the search from where it was stopped; the answer is the same as without the stop</source>
            <translation>Продолжить поиск с места остановки; ответ тот же, что и у поиска без остановки</translation>
        </message>
        <message>
            <source>The answer and the compared cycles</source>
            <translation>Ответ и с чем он сравнивается</translation>
        </message>
    </context>
    <context>
        <name>BatchCharts</name>
        <message>
            <source>parts that fail it; a part that fails several counts at each</source>
            <translation>детали с нарушением; деталь с несколькими учтена в каждом</translation>
        </message>
        <message>
            <source>share of all failures, summed up</source>
            <translation>накопленная доля всех нарушений</translation>
        </message>
        <message>
            <source>Size not reached</source>
            <translation>Размер не достигнут</translation>
        </message>
        <message>
            <source>Cause</source>
            <translation>Причина</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Детали</translation>
        </message>
        <message>
            <source>Share of the parts, %</source>
            <translation>Доля деталей, %</translation>
        </message>
        <message>
            <source>Share of all failures, summed up, %</source>
            <translation>Накопленная доля всех нарушений, %</translation>
        </message>
        <message numerus="yes">
            <source>%1: %n part(s), %2 % of the batch</source>
            <translation>
                <numerusform>%1: %n деталь, %2 % партии</numerusform>
                <numerusform>%1: %n детали, %2 % партии</numerusform>
                <numerusform>%1: %n деталей, %2 % партии</numerusform>
            </translation>
        </message>
        <message>
            <source>parts</source>
            <translation>детали</translation>
        </message>
        <message>
            <source>parts beyond a limit shown</source>
            <translation>детали за показанным пределом</translation>
        </message>
        <message>
            <source>worst part</source>
            <translation>худшая деталь</translation>
        </message>
        <message>
            <source>drawing limits</source>
            <translation>пределы по чертежу</translation>
        </message>
        <message>
            <source>Part</source>
            <translation>Деталь</translation>
        </message>
        <message>
            <source>Part %1: %2; %3</source>
            <translation>Деталь %1: %2; %3</translation>
        </message>
        <message>
            <source>mean</source>
            <translation>среднее</translation>
        </message>
        <message>
            <source>Where</source>
            <translation>Где</translation>
        </message>
        <message>
            <source>From</source>
            <translation>От</translation>
        </message>
        <message>
            <source>To</source>
            <translation>До</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message numerus="yes">
            <source>%1: %2 %3, %n part(s)</source>
            <translation>
                <numerusform>%1: %2 %3, %n деталь</numerusform>
                <numerusform>%1: %2 %3, %n детали</numerusform>
                <numerusform>%1: %2 %3, %n деталей</numerusform>
            </translation>
        </message>
        <message>
            <source>Characteristic</source>
            <translation>Характеристика</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PlaybackBar</name>
        <message>
            <source>Nothing to play</source>
            <translation>Нечего показывать</translation>
        </message>
        <message>
            <source>Pause</source>
            <translation>Пауза</translation>
        </message>
        <message>
            <source>Play</source>
            <translation>Пуск</translation>
        </message>
        <message>
            <source>Stop the cycle here</source>
            <translation>Остановить цикл здесь</translation>
        </message>
        <message>
            <source>Play the cycle, from the blank if it is at its end</source>
            <translation>Показать ход цикла; с конца — заново от заготовки</translation>
        </message>
        <message>
            <source>by stage</source>
            <translation>по ступеням</translation>
        </message>
        <message>
            <source>by double stroke</source>
            <translation>по двойным ходам</translation>
        </message>
        <message>
            <source>by step</source>
            <translation>по этапам</translation>
        </message>
        <message>
            <source>by revolution</source>
            <translation>по оборотам</translation>
        </message>
        <message>
            <source>by radius</source>
            <translation>по радиусам</translation>
        </message>
        <message>
            <source>%1 per second</source>
            <comment>steps of the playback</comment>
            <translation>%1 в секунду</translation>
        </message>
        <message>
            <source>Playback of the cycle</source>
            <translation>Показ хода цикла</translation>
        </message>
        <message>
            <source>To the blank</source>
            <translation>К заготовке</translation>
        </message>
        <message>
            <source>One step back</source>
            <translation>На шаг назад</translation>
        </message>
        <message>
            <source>One step forward</source>
            <translation>На шаг вперёд</translation>
        </message>
        <message>
            <source>To the end of the cycle</source>
            <translation>К концу цикла</translation>
        </message>
        <message>
            <source>Step of the playback</source>
            <translation>Что считается шагом показа</translation>
        </message>
        <message>
            <source>Speed of the playback, steps a second</source>
            <translation>Скорость показа, шагов в секунду</translation>
        </message>
        <message>
            <source>Place in the cycle</source>
            <translation>Место в цикле</translation>
        </message>
        <message>
            <source>Blank, before the first touch</source>
            <translation>Заготовка, до первого касания</translation>
        </message>
        <message>
            <source>Stage %1, double stroke %2 of %3</source>
            <translation>Ступень %1, двойной ход %2 из %3</translation>
        </message>
        <message>
            <source>Stage %1, revolution %2 of %3</source>
            <translation>Ступень %1, оборот %2 из %3</translation>
        </message>
        <message>
            <source>%1 (%2)</source>
            <comment>what a step is; the zones and their steps</comment>
            <translation>%1 (%2)</translation>
        </message>
        <message>
            <source>revolution %1</source>
            <translation>оборот %1</translation>
        </message>
        <message>
            <source>radius %1</source>
            <translation>радиус %1</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 с</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PlotCursors</name>
        <message>
            <source>Cursors</source>
            <translation>Курсоры</translation>
        </message>
        <message>
            <source>Two cursors: the curves&apos; values at A and at B, and their differences. Drag them, type their places, or move A with Shift and arrows, B with Ctrl+Shift and arrows.</source>
            <translation>Два курсора: значения кривых в A и в B и их разности. Курсоры перетаскивают мышью, ставят числом или двигают клавишами: A — Shift и стрелки, B — Ctrl+Shift и стрелки.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PlotTools</name>
        <message>
            <source>PNG pictures (*.png)</source>
            <translation>Рисунки PNG (*.png)</translation>
        </message>
        <message>
            <source>SVG drawings (*.svg)</source>
            <translation>Векторные рисунки SVG (*.svg)</translation>
        </message>
        <message>
            <source>PDF documents (*.pdf)</source>
            <translation>Документы PDF (*.pdf)</translation>
        </message>
        <message>
            <source>The picture is on the clipboard.</source>
            <translation>Рисунок скопирован в буфер обмена.</translation>
        </message>
        <message>
            <source>The data are on the clipboard.</source>
            <translation>Данные скопированы в буфер обмена.</translation>
        </message>
        <message>
            <source>Save the picture</source>
            <translation>Сохранить рисунок</translation>
        </message>
        <message>
            <source>Show all</source>
            <translation>Показать всё</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>Назад</translation>
        </message>
        <message>
            <source>Forward</source>
            <translation>Вперёд</translation>
        </message>
        <message>
            <source>&amp;Copy the picture</source>
            <translation>&amp;Копировать рисунок</translation>
        </message>
        <message>
            <source>Copy the &amp;data</source>
            <translation>Копировать &amp;данные</translation>
        </message>
        <message>
            <source>P&amp;NG picture</source>
            <translation>Рисунок &amp;PNG</translation>
        </message>
        <message>
            <source>CSV &amp;table</source>
            <translation>&amp;Таблица CSV</translation>
        </message>
        <message>
            <source>&amp;SVG drawing…</source>
            <translation>Векторный рисунок &amp;SVG…</translation>
        </message>
        <message>
            <source>&amp;PDF drawing…</source>
            <translation>Документ P&amp;DF…</translation>
        </message>
        <message>
            <source>&amp;%1×: %2 × %3 pixels…</source>
            <translation>&amp;%1×: %2 × %3 точек…</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>Экспорт</translation>
        </message>
        <message>
            <source>Copy or save the contents of the plot</source>
            <translation>Скопировать или сохранить то, что на графике</translation>
        </message>
        <message>
            <source>Show all; a double click in the plot does it too. Wheel: zoom, over an axis that axis only, with Shift move. Drag: move. Keys: + − and arrows.</source>
            <translation>Показать всё; так же действует двойной щелчок на графике. Колёсико: масштаб, над осью — только этой оси, с Shift — сдвиг. Перетаскивание: сдвиг. Клавиши: + − и стрелки.</translation>
        </message>
        <message>
            <source>Back to the previous visible range</source>
            <translation>Назад, к тому, что было видно раньше</translation>
        </message>
        <message>
            <source>Forward again</source>
            <translation>Снова вперёд</translation>
        </message>
        <message>
            <source>Export: %1</source>
            <translation>Экспорт: %1</translation>
        </message>
        <message>
            <source>Copy or save: %1</source>
            <translation>Копировать или сохранить: %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ProfilesPlot</name>
        <message>
            <source>%1: profile</source>
            <translation>%1: профиль</translation>
        </message>
        <message>
            <source>%1: blank</source>
            <translation>%1: заготовка</translation>
        </message>
        <message>
            <source>%1: least-squares circle</source>
            <translation>%1: средняя окружность (МНК)</translation>
        </message>
        <message>
            <source>%1 (gauge)</source>
            <translation>%1 (ПАК)</translation>
        </message>
        <message>
            <source>Deviations from the target radius drawn %1, scale in µm</source>
            <translation>Отклонения от целевого радиуса %1, мкм</translation>
        </message>
        <message>
            <source>Deviations from each one&apos;s mean radius drawn %1, scale in µm</source>
            <translation>Отклонения от своего среднего радиуса %1, мкм</translation>
        </message>
        <message>
            <source>%1; straight lines between the %2 radii</source>
            <translation>%1; между радиусами (%2) — отрезки прямых</translation>
        </message>
        <message>
            <source>%1: inner circle of the minimum zone</source>
            <translation>%1: внутренняя окружность минимальной зоны</translation>
        </message>
        <message>
            <source>%1: outer circle of the minimum zone</source>
            <translation>%1: наружная окружность минимальной зоны</translation>
        </message>
        <message>
            <source>%1: maximum inscribed circle</source>
            <translation>%1: максимальная вписанная окружность</translation>
        </message>
        <message>
            <source>%1: circle about its centre, outside</source>
            <translation>%1: окружность с тем же центром, снаружи</translation>
        </message>
        <message>
            <source>%1: circle about its centre, inside</source>
            <translation>%1: окружность с тем же центром, внутри</translation>
        </message>
        <message>
            <source>%1: minimum circumscribed circle</source>
            <translation>%1: минимальная описанная окружность</translation>
        </message>
        <message>
            <source>Measured</source>
            <translation>Измерено</translation>
        </message>
        <message>
            <source>the circle does not exist</source>
            <translation>окружность не определена</translation>
        </message>
        <message>
            <source>Measured profile %1: %2</source>
            <translation>Измеренный профиль %1: %2</translation>
        </message>
        <message>
            <source>Measured: %1</source>
            <translation>Измерено: %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ProfilesView</name>
        <message>
            <source>Zone profiles</source>
            <translation>Профили зон</translation>
        </message>
        <message>
            <source>Cross-sections with magnified deviations</source>
            <translation>Поперечные сечения с увеличенными отклонениями</translation>
        </message>
        <message>
            <source>Profile along the axis</source>
            <translation>Продольный профиль</translation>
        </message>
        <message>
            <source>Legend of the curves</source>
            <translation>Обозначения кривых</translation>
        </message>
        <message>
            <source>State of the profiles</source>
            <translation>Состояние профилей</translation>
        </message>
        <message>
            <source>Values under the pointer</source>
            <translation>Значения под указателем</translation>
        </message>
        <message>
            <source>Sections and length</source>
            <translation>Сечения и длина</translation>
        </message>
        <message>
            <source>Sections only</source>
            <translation>Только сечения</translation>
        </message>
        <message>
            <source>Length only</source>
            <translation>Только длина</translation>
        </message>
        <message>
            <source>from target</source>
            <translation>от целевого</translation>
        </message>
        <message>
            <source>from own mean</source>
            <translation>от среднего</translation>
        </message>
        <message>
            <source>Radii</source>
            <translation>Радиусы</translation>
        </message>
        <message>
            <source>Diameters</source>
            <translation>Диаметры</translation>
        </message>
        <message>
            <source>Only this</source>
            <translation>Только оно</translation>
        </message>
        <message>
            <source>Blank</source>
            <translation>Заготовка</translation>
        </message>
        <message>
            <source>To scale</source>
            <translation>В масштабе</translation>
        </message>
        <message>
            <source>Displayed content</source>
            <translation>Что показано</translation>
        </message>
        <message>
            <source>Zone or section to show</source>
            <translation>Рассматриваемая зона или сечение</translation>
        </message>
        <message>
            <source>Only the chosen section, large</source>
            <translation>Только выбранное сечение, крупно</translation>
        </message>
        <message>
            <source>Magnification of the deviations, the same for all; ×1 is the true shape</source>
            <translation>Увеличение отклонений, одно для всех; ×1 — истинная форма</translation>
        </message>
        <message>
            <source>Radius from which deviations are measured: the target shows size and form, the own mean shows only form</source>
            <translation>От какого радиуса отсчитаны отклонения: от целевого — видны размер и форма, от своего среднего — только форма</translation>
        </message>
        <message>
            <source>The profile before the first touch</source>
            <translation>Профиль до первого касания</translation>
        </message>
        <message>
            <source>Previous</source>
            <translation>Предыдущий</translation>
        </message>
        <message>
            <source>Next</source>
            <translation>Следующий</translation>
        </message>
        <message>
            <source>Along the axis: deviations of radii from the target, or of diameters from nominal</source>
            <translation>Вдоль оси: отклонения радиусов от целевого или диаметров от номинала</translation>
        </message>
        <message>
            <source>The part along its axis without exaggeration</source>
            <translation>Деталь вдоль оси без увеличения отклонений</translation>
        </message>
        <message>
            <source>Moment of the cycle</source>
            <translation>Момент цикла</translation>
        </message>
        <message>
            <source>blank</source>
            <comment>before the first stroke</comment>
            <translation>заготовка</translation>
        </message>
        <message>
            <source>Point at a profile to read its values.</source>
            <translation>Наведите указатель на профиль, чтобы прочитать значения.</translation>
        </message>
        <message>
            <source>The inputs are refused; the profiles are those of the last valid inputs.</source>
            <translation>Исходные данные не приняты; профили — по последним верным.</translation>
        </message>
        <message>
            <source>The cycle is too long to be recorded: only its end is shown.</source>
            <translation>Цикл слишком длинный для записи: показан только его конец.</translation>
        </message>
        <message>
            <source>Double stroke</source>
            <translation>Двойной ход</translation>
        </message>
        <message>
            <source>Revolution</source>
            <translation>Оборот</translation>
        </message>
        <message>
            <source> of %1</source>
            <translation> из %1</translation>
        </message>
        <message>
            <source>All zones</source>
            <translation>Все зоны</translation>
        </message>
        <message>
            <source>Evenly chosen</source>
            <translation>Выборочно</translation>
        </message>
        <message>
            <source>All sections</source>
            <translation>Все сечения</translation>
        </message>
        <message>
            <source>Auto</source>
            <translation>Авто</translation>
        </message>
        <message>
            <source>Auto: %1</source>
            <translation>Авто: %1</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>cross-sections</source>
            <translation>поперечные сечения</translation>
        </message>
        <message>
            <source>along the axis</source>
            <translation>вдоль оси</translation>
        </message>
        <message>
            <source>Show all in both plots; in one of them: Home, or a double click in it. Wheel: zoom. Drag: move.</source>
            <translation>Показать всё на обоих графиках; на одном: Home или двойной щелчок по нему. Колесо: масштаб. Перетаскивание: сдвиг.</translation>
        </message>
        <message>
            <source>spectra of the cross-sections</source>
            <translation>спектры сечений</translation>
        </message>
        <message>
            <source>Spectra of the cross-sections</source>
            <translation>Спектры сечений</translation>
        </message>
        <message>
            <source>Sections and spectrum</source>
            <translation>Сечения и спектр</translation>
        </message>
        <message>
            <source>Spectrum only</source>
            <translation>Только спектр</translation>
        </message>
        <message>
            <source>LSCI</source>
            <translation>МНК</translation>
        </message>
        <message>
            <source>MZCI</source>
            <translation>мин. зона</translation>
        </message>
        <message>
            <source>none</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>Logarithmic</source>
            <translation>Логарифм.</translation>
        </message>
        <message>
            <source>Amplitudes on a logarithmic axis</source>
            <translation>Амплитуды по логарифмической оси</translation>
        </message>
        <message>
            <source>Profiles</source>
            <comment>the view&apos;s tab</comment>
            <translation>Профили</translation>
        </message>
        <message>
            <source>MICI</source>
            <translation>вписанная</translation>
        </message>
        <message>
            <source>MCCI</source>
            <translation>описанная</translation>
        </message>
        <message>
            <source>%1 UPR</source>
            <translation>%1 волн/об</translation>
        </message>
        <message>
            <source>Measured</source>
            <translation>Измеренный</translation>
        </message>
        <message>
            <source>&amp;Read a measured profile…</source>
            <translation>&amp;Прочитать измеренный профиль…</translation>
        </message>
        <message>
            <source>&amp;Remove profile</source>
            <translation>&amp;Убрать профиль</translation>
        </message>
        <message>
            <source>Reference circles of the roundness (ISO 12181): LSCI, the least-squares circle; MZCI, the two circles of the minimum zone; MICI, the maximum inscribed, or MCCI, the minimum circumscribed circle</source>
            <translation>Базовые окружности круглости (ISO 12181): МНК — средняя окружность, мин. зона — две окружности минимальной зоны, вписанная — максимальная вписанная, описанная — минимальная описанная окружность</translation>
        </message>
        <message>
            <source>Gaussian filter of the cross-sections (ISO 16610-21): keeps waves up to about this number of undulations per revolution, as on roundness machines</source>
            <translation>Фильтр Гаусса для поперечных сечений (ISO 16610-21): остаются волны примерно до стольких на оборот, как указывают кругломеры</translation>
        </message>
        <message>
            <source>A profile recorded by a roundness machine, beside the predicted ones: a table of the angle in ° and the radius in mm or its deviation in µm</source>
            <translation>Профиль, записанный кругломером, рядом с расчётными: таблица из угла в ° и радиуса в мм или его отклонения в мкм</translation>
        </message>
    </context>
    <context>
        <name>sparkout::RadiiEditor</name>
        <message>
            <source>Read a measured profile</source>
            <translation>Чтение измеренного профиля</translation>
        </message>
        <message>
            <source>Tables (*.csv *.txt *.tsv *.dat);;All files (*)</source>
            <translation>Таблицы (*.csv *.txt *.tsv *.dat);;Все файлы (*)</translation>
        </message>
        <message>
            <source>“%1” was not read: %2</source>
            <translation>Файл «%1» не принят: %2</translation>
        </message>
        <message numerus="yes">
            <source>%n values, %1…%2 %3</source>
            <translation>
                <numerusform>%n значение, %1…%2 %3</numerusform>
                <numerusform>%n значения, %1…%2 %3</numerusform>
                <numerusform>%n значений, %1…%2 %3</numerusform>
            </translation>
        </message>
        <message>
            <source>Read from CSV…</source>
            <translation>Прочитать из CSV…</translation>
        </message>
        <message>
            <source>Clear</source>
            <translation>Очистить</translation>
        </message>
        <message>
            <source>%1: read from a CSV file</source>
            <translation>%1: прочитать из файла CSV</translation>
        </message>
        <message>
            <source>%1: clear</source>
            <translation>%1: очистить</translation>
        </message>
        <message>
            <source>A number a line in µm, or the last column of a table; the number of values becomes the number of radii per section.</source>
            <translation>По числу в строке, мкм, или последний столбец таблицы; количество значений станет числом радиусов в сечении.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::RangeEditor</name>
        <message>
            <source>minimum, maximum and step are needed, or none of them</source>
            <translation>нужны наименьшее, наибольшее и шаг либо ничего из них</translation>
        </message>
        <message>
            <source>minimum</source>
            <translation>наименьшее</translation>
        </message>
        <message>
            <source>maximum</source>
            <translation>наибольшее</translation>
        </message>
        <message>
            <source>step</source>
            <translation>шаг</translation>
        </message>
        <message>
            <source>%1: %2, %3</source>
            <translation>%1: %2, %3</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>from</source>
            <translation>от</translation>
        </message>
        <message>
            <source>to</source>
            <translation>до</translation>
        </message>
        <message>
            <source>step</source>
            <comment>after from and to</comment>
            <translation>шаг</translation>
        </message>
        <message>
            <source>the minimum is above the maximum</source>
            <translation>наименьшее значение больше наибольшего</translation>
        </message>
    </context>
    <context>
        <name>sparkout::RecentFilesMenu</name>
        <message>
            <source>%1 (missing)</source>
            <translation>%1 (отсутствует)</translation>
        </message>
        <message>
            <source>Open &amp;recent</source>
            <translation>Открыть не&amp;давние</translation>
        </message>
        <message>
            <source>Remove the &amp;missing ones</source>
            <translation>Убрать &amp;отсутствующие</translation>
        </message>
        <message>
            <source>&amp;Clear the list</source>
            <translation>О&amp;чистить список</translation>
        </message>
    </context>
    <context>
        <name>sparkout::RecoveryDialog</name>
        <message>
            <source>complete</source>
            <translation>цел</translation>
        </message>
        <message>
            <source>damaged</source>
            <translation>повреждён</translation>
        </message>
        <message>
            <source>discarded</source>
            <translation>отброшен</translation>
        </message>
        <message>
            <source>Recover work</source>
            <translation>Восстановление работы</translation>
        </message>
        <message>
            <source>Unsaved work</source>
            <translation>Несохранённая работа</translation>
        </message>
        <message>
            <source>Project</source>
            <translation>Проект</translation>
        </message>
        <message>
            <source>File</source>
            <translation>Файл</translation>
        </message>
        <message>
            <source>Kept at</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>State</source>
            <translation>Состояние</translation>
        </message>
        <message numerus="yes">
            <source>Recovery files are kept in %1; discarded ones stay in %2 for %n days.</source>
            <translation>
                <numerusform>Файлы восстановления лежат в %1; отброшенные хранятся в %2 %n день.</numerusform>
                <numerusform>Файлы восстановления лежат в %1; отброшенные хранятся в %2 %n дня.</numerusform>
                <numerusform>Файлы восстановления лежат в %1; отброшенные хранятся в %2 %n дней.</numerusform>
            </translation>
        </message>
        <message>
            <source>&amp;Recover</source>
            <translation>&amp;Восстановить</translation>
        </message>
        <message>
            <source>&amp;Discard</source>
            <translation>&amp;Отбросить</translation>
        </message>
        <message>
            <source>&amp;Later</source>
            <translation>&amp;Позже</translation>
        </message>
        <message>
            <source>Work that was not saved was found. Recovering opens it here, still unsaved; your own files stay unchanged.</source>
            <translation>Найдена несохранённая работа. Восстановленный проект откроется здесь и останется несохранённым; ваши файлы не изменятся.</translation>
        </message>
        <message>
            <source>never saved</source>
            <translation>не сохранялся</translation>
        </message>
        <message>
            <source>Untitled</source>
            <translation>Без имени</translation>
        </message>
        <message>
            <source>Another window already offers the unsaved work that was found. Answer there first, then try again.</source>
            <translation>Найденную несохранённую работу уже предлагает другое окно. Когда там будет дан ответ, спросите снова о том, что осталось.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ReportCommands</name>
        <message>
            <source>No report</source>
            <translation>Нет отчёта</translation>
        </message>
        <message>
            <source>There is no result of these inputs, so there is nothing to report. The messages list the faults.</source>
            <translation>По этим данным результата нет, поэтому отчёт составить не из чего. Что в них не так, сказано в сообщениях.</translation>
        </message>
        <message>
            <source>Batch of the report</source>
            <translation>Партия для отчёта</translation>
        </message>
        <message>
            <source>The batch cannot be run:</source>
            <translation>Партию нельзя рассчитать:</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ResetMark</name>
        <message>
            <source>Changed; the default is: %1. Click to go back to it.</source>
            <translation>Изменено; по умолчанию: %1. Щелчок возвращает это значение.</translation>
        </message>
        <message>
            <source>%1: reset to the default</source>
            <translation>%1: вернуть значение по умолчанию</translation>
        </message>
        <message>
            <source>&amp;Reset to the default (%1)</source>
            <translation>&amp;Вернуть по умолчанию (%1)</translation>
        </message>
    </context>
    <context>
        <name>sparkout::RowSliders</name>
        <message>
            <source>%1 %2</source>
            <translation>%1 %2</translation>
        </message>
        <message>
            <source>%1 %2, %3, slider</source>
            <translation>%1 %2, %3, ползунок</translation>
        </message>
        <message>
            <source>Sliders of the selected row</source>
            <translation>Ползунки выбранной строки</translation>
        </message>
    </context>
    <context>
        <name>sparkout::RowsEditor</name>
        <message numerus="yes">
            <source>rows of %n number(s) separated by semicolons, as in 0 50; 200 80</source>
            <translation>
                <numerusform>строки по %n числу через точку с запятой, например 50; 80</numerusform>
                <numerusform>строки по %n числа через точку с запятой, например 0 50; 200 80</numerusform>
                <numerusform>строки по %n чисел через точку с запятой, например 0 50; 200 80</numerusform>
            </translation>
        </message>
        <message>
            <source>the forces must rise from row to row, the stiffnesses lie above 0</source>
            <translation>силы должны расти от строки к строке, жёсткости быть больше 0</translation>
        </message>
        <message>
            <source>a number is out of range</source>
            <translation>число вне допустимых пределов</translation>
        </message>
    </context>
    <context>
        <name>sparkout::RunKeeper</name>
        <message>
            <source>Kept as “%1”; the view Compare draws it over the current run.</source>
            <translation>Запомнен как «%1»; на вкладке «Сравнение» он наложен на текущий расчёт.</translation>
        </message>
        <message>
            <source>The run was not kept: the project file would grow too large. Delete kept runs that are no longer needed.</source>
            <translation>Расчёт не запомнен: файл проекта стал бы слишком большим. Удалите ненужные запомненные расчёты.</translation>
        </message>
        <message>
            <source>There is no run to keep: the inputs are refused.</source>
            <translation>Расчёт не запомнен: исходные данные не приняты, поэтому его нет.</translation>
        </message>
        <message numerus="yes">
            <source>%n kept runs give other results with this version of the program: %1.</source>
            <translation>
                <numerusform>В этой версии программы %n запомненный расчёт получается иначе, чем был запомнен: %1.</numerusform>
                <numerusform>В этой версии программы %n запомненных расчёта получаются иначе, чем были запомнены: %1.</numerusform>
                <numerusform>В этой версии программы %n запомненных расчётов получаются иначе, чем были запомнены: %1.</numerusform>
            </translation>
        </message>
        <message>
            <source>Show the differences</source>
            <translation>Показать различия</translation>
        </message>
        <message>
            <source>The run was not kept: the inputs were changed before it was computed.</source>
            <translation>Расчёт не запомнен: исходные данные изменились до его окончания.</translation>
        </message>
        <message>
            <source>“%1” is being computed and will be kept.</source>
            <translation>«%1»: идёт расчёт, он будет запомнен.</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Остановить</translation>
        </message>
        <message>
            <source>Stopped; nothing was kept.</source>
            <translation>Остановлено; ничего не запомнено.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::RunsPanel</name>
        <message>
            <source>Current run</source>
            <translation>Текущий расчёт</translation>
        </message>
        <message>
            <source>not computed yet</source>
            <translation>ещё не рассчитан</translation>
        </message>
        <message>
            <source>results not readable</source>
            <translation>итоги не читаются</translation>
        </message>
        <message>
            <source>no results kept</source>
            <translation>результаты не сохранены</translation>
        </message>
        <message>
            <source>computing…</source>
            <translation>считается…</translation>
        </message>
        <message>
            <source>refused by this version</source>
            <translation>теперь отклонён</translation>
        </message>
        <message>
            <source>results differ</source>
            <translation>результаты отличаются</translation>
        </message>
        <message>
            <source>Current run, always drawn</source>
            <translation>Текущий расчёт, показан всегда</translation>
        </message>
        <message>
            <source>Kept %1 by version %2</source>
            <translation>Запомнен %1 версией %2</translation>
        </message>
        <message>
            <source>Runs; a check mark draws a run over the current one</source>
            <translation>Расчёты; отмеченный накладывается на текущий</translation>
        </message>
        <message>
            <source>Keep the current run</source>
            <translation>Запомнить текущий расчёт</translation>
        </message>
        <message>
            <source>Keep the inputs and results of the current run for comparison</source>
            <translation>Запомнить текущий расчёт: исходные данные и результаты, для сравнения</translation>
        </message>
        <message>
            <source>Restore the inputs</source>
            <translation>Вернуть исходные данные</translation>
        </message>
        <message>
            <source>Replace the current inputs with those of the selected run; the kept runs remain</source>
            <translation>Применить исходные данные выбранного расчёта вместо текущих; запомненные расчёты остаются</translation>
        </message>
        <message>
            <source>Rename</source>
            <translation>Переименовать</translation>
        </message>
        <message>
            <source>Rename the selected run</source>
            <translation>Переименовать выбранный расчёт</translation>
        </message>
        <message>
            <source>Delete</source>
            <translation>Удалить</translation>
        </message>
        <message>
            <source>Delete the selected run</source>
            <translation>Удалить выбранный расчёт</translation>
        </message>
    </context>
    <context>
        <name>sparkout::SecondAxisMenu</name>
        <message>
            <source>Right-hand axes</source>
            <translation>Правые оси</translation>
        </message>
        <message>
            <source>Right-hand axes: the second quantity of the upper and of the lower plot</source>
            <translation>Правые оси: вторая величина верхнего и нижнего графика</translation>
        </message>
        <message>
            <source>Above: %1</source>
            <translation>Вверху: %1</translation>
        </message>
        <message>
            <source>Below: %1</source>
            <translation>Внизу: %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::SensitivityPlot</name>
        <message>
            <source>%1, R² %2</source>
            <comment>RZ1, R² 0.97</comment>
            <translation>%1, R² %2</translation>
        </message>
        <message>
            <source>Where</source>
            <translation>Где</translation>
        </message>
        <message>
            <source>Factor</source>
            <translation>Фактор</translation>
        </message>
        <message>
            <source>Standardised rank regression</source>
            <translation>Стандартизованная ранговая регрессия</translation>
        </message>
        <message>
            <source>R²</source>
            <translation>R²</translation>
        </message>
        <message>
            <source>Sobol index, first order</source>
            <translation>Индекс Соболя первого порядка</translation>
        </message>
        <message>
            <source>Sobol index, total</source>
            <translation>Полный индекс Соболя</translation>
        </message>
        <message>
            <source>%1: %2 of the standardised rank regression</source>
            <translation>%1: %2 по стандартизованной ранговой регрессии</translation>
        </message>
        <message>
            <source>%1: %2 of the variance alone, %3 with its interactions</source>
            <translation>%1: %2 дисперсии сам по себе, %3 со взаимодействиями</translation>
        </message>
        <message>
            <source>Coefficient of the standardised rank regression</source>
            <translation>Коэффициент стандартизованной ранговой регрессии</translation>
        </message>
        <message>
            <source>Characteristic</source>
            <translation>Характеристика</translation>
        </message>
        <message>
            <source>Share of the variance</source>
            <translation>Доля дисперсии</translation>
        </message>
        <message>
            <source>%1 alone</source>
            <comment>zone</comment>
            <translation>%1 отдельно</translation>
        </message>
        <message>
            <source>%1 with interactions</source>
            <comment>zone</comment>
            <translation>%1 с взаимодействиями</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ShaftScene</name>
        <message>
            <source>tailstock</source>
            <translation>задняя бабка</translation>
        </message>
        <message>
            <source>headstock</source>
            <translation>передняя бабка</translation>
        </message>
        <message>
            <source>wheel head</source>
            <translation>шлифовальная бабка</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ShopSection</name>
        <message>
            <source>Grinding quantities by stage</source>
            <translation>Показатели шлифования по ступеням</translation>
        </message>
        <message>
            <source>Values outside the usual range</source>
            <translation>Что выходит за обычное</translation>
        </message>
    </context>
    <context>
        <name>sparkout::SidePlot</name>
        <message>
            <source>wheel</source>
            <translation>круг</translation>
        </message>
        <message>
            <source>surface under load</source>
            <translation>поверхность под нагрузкой</translation>
        </message>
        <message>
            <source>without load</source>
            <translation>без нагрузки</translation>
        </message>
        <message>
            <source>tolerance band</source>
            <translation>поле допуска</translation>
        </message>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>From, mm</source>
            <translation>От, мм</translation>
        </message>
        <message>
            <source>To, mm</source>
            <translation>До, мм</translation>
        </message>
        <message>
            <source>Radius from target, µm</source>
            <translation>Радиус от целевого, мкм</translation>
        </message>
        <message>
            <source>Yield, µm</source>
            <translation>Отжатие, мкм</translation>
        </message>
        <message>
            <source>y %1 µm</source>
            <translation>y %1 мкм</translation>
        </message>
        <message>
            <source>gauge</source>
            <translation>ПАК</translation>
        </message>
        <message>
            <source>%1, radius %2: the wheel does not touch it; programmed %3 µm.</source>
            <translation>%1, радиус %2: круг его не касается; программная подача %3 мкм.</translation>
        </message>
        <message>
            <source>%1, radius %2: programmed %3 µm; lag %4 µm = cut %5 µm + yield %6 µm; normal force %7 N.</source>
            <translation>%1, радиус %2: программная подача %3 мкм; отставание %4 мкм = срез %5 мкм + отжатие %6 мкм; нормальная сила %7 Н.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::SizeHelper</name>
        <message>
            <source>Tolerance class</source>
            <translation>Поле допуска</translation>
        </message>
        <message>
            <source>Size with its tolerance class</source>
            <translation>Размер с полем допуска</translation>
        </message>
        <message>
            <source>ISO 286: 30h6 fills diameter and limits; h6 keeps the diameter</source>
            <translation>ГОСТ 25346: 30h6 заполняет диаметр и отклонения; h6 оставляет диаметр</translation>
        </message>
        <message>
            <source>Meaning of the tolerance class</source>
            <translation>Что значит поле допуска</translation>
        </message>
        <message>
            <source>e.g. %1</source>
            <translation>напр. %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::SparkOutEditor</name>
        <message>
            <source>Double strokes of spark-out</source>
            <translation>Число двойных ходов выхаживания</translation>
        </message>
        <message>
            <source>Revolutions of spark-out</source>
            <translation>Число оборотов выхаживания</translation>
        </message>
        <message>
            <source>none</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>double strokes</source>
            <translation>двойные ходы</translation>
        </message>
        <message>
            <source>revolutions</source>
            <translation>обороты</translation>
        </message>
        <message>
            <source>until size</source>
            <translation>до размера</translation>
        </message>
    </context>
    <context>
        <name>SpectrumCharts</name>
        <message>
            <source>Undulations per revolution</source>
            <translation>Волн на оборот</translation>
        </message>
        <message>
            <source>Amplitude, µm</source>
            <translation>Амплитуда, мкм</translation>
        </message>
        <message>
            <source>%1, %2 undulation per revolution (eccentricity): amplitude %3 µm, of the blank %4 µm</source>
            <translation>%1, %2 волна на оборот (эксцентриситет): амплитуда %3 мкм, у заготовки %4 мкм</translation>
        </message>
        <message>
            <source>%1, %2 undulations per revolution: amplitude %3 µm, of the blank %4 µm</source>
            <translation>%1, волн на оборот %2: амплитуда %3 мкм, у заготовки %4 мкм</translation>
        </message>
        <message>
            <source>undulations per revolution</source>
            <translation>волн на оборот</translation>
        </message>
        <message>
            <source>blank: amplitude, µm</source>
            <translation>заготовка: амплитуда, мкм</translation>
        </message>
        <message>
            <source>%1: amplitude, µm</source>
            <translation>%1: амплитуда, мкм</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StageCountPlot</name>
        <message>
            <source>quickest cycle</source>
            <translation>самый быстрый цикл</translation>
        </message>
        <message>
            <source>none is below</source>
            <translation>быстрее нет</translation>
        </message>
        <message>
            <source>your cycle</source>
            <translation>ваш цикл</translation>
        </message>
        <message>
            <source>stepless limit</source>
            <translation>предел бесступенчатого цикла</translation>
        </message>
        <message>
            <source>Stages</source>
            <translation>Ступени</translation>
        </message>
        <message>
            <source>Time of the quickest cycle</source>
            <translation>Время самого быстрого цикла</translation>
        </message>
        <message>
            <source>None is below</source>
            <translation>Быстрее нет</translation>
        </message>
        <message>
            <source>Stepless limit</source>
            <translation>Предел бесступенчатого цикла</translation>
        </message>
        <message numerus="yes">
            <source>%n stage(s)</source>
            <translation>
                <numerusform>%n ступень</numerusform>
                <numerusform>%n ступени</numerusform>
                <numerusform>%n ступеней</numerusform>
            </translation>
        </message>
        <message>
            <source>%1: no cycle was found that meets every requirement</source>
            <translation>%1: цикл, который выдерживает все требования, не найден</translation>
        </message>
        <message>
            <source>Machining time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>cycle with the maximum margin</source>
            <translation>цикл с наибольшим запасом</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StageModel</name>
        <message>
            <source>none</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>until size</source>
            <translation>до размера</translation>
        </message>
        <message numerus="yes">
            <source>%n double strokes</source>
            <translation>
                <numerusform>%n дв. ход</numerusform>
                <numerusform>%n дв. хода</numerusform>
                <numerusform>%n дв. ходов</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n revolutions</source>
            <translation>
                <numerusform>%n оборот</numerusform>
                <numerusform>%n оборота</numerusform>
                <numerusform>%n оборотов</numerusform>
            </translation>
        </message>
        <message>
            <source>Stage %1: %2 s, %3 of the machining time</source>
            <translation>Ступень %1: %2 с, %3 основного времени</translation>
        </message>
        <message>
            <source>Time, s</source>
            <translation>Время, с</translation>
        </message>
        <message>
            <source>Machining time of the stage and its share of the cycle&apos;s.</source>
            <translation>Основное время ступени и его доля в цикле.</translation>
        </message>
        <message>
            <source>spark-out “%1” is invalid; allowed: %2, “%3”, “%4”</source>
            <translation>выхаживание «%1» недопустимо; допускается: %2, «%3», «%4»</translation>
        </message>
        <message>
            <source>“%1”: only the last stage may spark out</source>
            <translation>«%1»: выхаживать может только последняя ступень</translation>
        </message>
        <message>
            <source>%1 mm/rev</source>
            <translation>%1 мм/об</translation>
        </message>
        <message>
            <source>%1 B</source>
            <comment>share of the wheel's width</comment>
            <translation>%1 B</translation>
        </message>
        <message>
            <source>12 mm/rev or 0.3B may also be typed.</source>
            <translation>Можно ввести и так: 12 мм/об или 0,3B.</translation>
        </message>
        <message>
            <source>0.005 mm/rev may also be typed.</source>
            <translation>Можно ввести и так: 0,005 мм/об.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StageTable</name>
        <message>
            <source>Continuous infeed</source>
            <translation>Непрерывная радиальная подача</translation>
        </message>
        <message>
            <source>The wheel is fed continuously while the table travels; each stage has a column for it.</source>
            <translation>Круг подаётся всё время движения стола; у каждой ступени для этого есть столбец.</translation>
        </message>
        <message>
            <source>Fit the stocks</source>
            <translation>Согласовать припуски</translation>
        </message>
        <message>
            <source>Stages</source>
            <translation>Ступени</translation>
        </message>
        <message>
            <source>Stages of the cycle</source>
            <translation>Ступени цикла</translation>
        </message>
        <message>
            <source>Add a stage</source>
            <translation>Добавить ступень</translation>
        </message>
        <message>
            <source>Remove the stage</source>
            <translation>Удалить ступень</translation>
        </message>
        <message>
            <source>Move the stage up</source>
            <translation>Переместить ступень вверх</translation>
        </message>
        <message>
            <source>Move the stage down</source>
            <translation>Переместить ступень вниз</translation>
        </message>
        <message>
            <source>+ Spark-out</source>
            <translation>+ Выхаживание</translation>
        </message>
        <message>
            <source>Adds a spark-out after the last feed; the stocks stay as they are</source>
            <translation>Добавляет выхаживание после последней подачи; припуски остаются прежними</translation>
        </message>
        <message>
            <source>Starting cycle</source>
            <translation>Исходный цикл</translation>
        </message>
        <message>
            <source>Work speed, feeds, stocks, spark-out, overruns and dwells as a shop would first set them for this part, wheel and machine; an estimate</source>
            <translation>Частота вращения заготовки, подачи, припуски, выхаживание, перебеги и выстой, с которых начал бы цех для этой детали, круга и станка; оценка</translation>
        </message>
        <message>
            <source>A starting cycle: it follows the drawing, material, wheel and machine until any other input is edited.</source>
            <translation>Исходный цикл: меняется вместе с чертежом, материалом, кругом и станком, пока не изменена любая другая исходная величина.</translation>
        </message>
        <message>
            <source>Its rough depth of cut is the usual one, %1.</source>
            <translation>Черновая глубина резания обычная, %1.</translation>
        </message>
        <message>
            <source>Wheel: %1.</source>
            <translation>Круг: %1.</translation>
        </message>
        <message>
            <source>Its rough depth of cut, %1, is the machine&apos;s minimum and more than %2 allows; usual: %3.</source>
            <translation>Черновая глубина резания, %1, — наименьшая у станка и больше, чем допускает %2; обычная — %3.</translation>
        </message>
        <message>
            <source>Its rough depth of cut, %1, is limited by %2; usual: %3.</source>
            <translation>Черновую глубину резания, %1, ограничивает %2; обычная — %3.</translation>
        </message>
        <message>
            <source>Edited: the cycle no longer follows the drawing. “%1” creates a new one.</source>
            <translation>Изменено: цикл больше не меняется вместе с чертежом. «%1» строит его заново.</translation>
        </message>
        <message>
            <source>Whether the cycle follows the drawing</source>
            <translation>Меняется ли цикл вместе с чертежом</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StepSheet</name>
        <message>
            <source>%1, %2: %3</source>
            <comment>zone, E1, what that is</comment>
            <translation>%1, %2: %3</translation>
        </message>
        <message>
            <source>Grinding has not started. Step on or press Play below the views: the formulas of each step are shown here with their numbers.</source>
            <translation>Шлифование не начато: деталь — заготовка. Сделайте шаг вперёд или нажмите «Пуск» под графиками: здесь появятся формулы каждого этапа с числами.</translation>
        </message>
        <message>
            <source>No cycle has been recorded.</source>
            <translation>Цикл не записан.</translation>
        </message>
        <message>
            <source>radius k = %1</source>
            <translation>радиус k = %1</translation>
        </message>
        <message>
            <source>%1, %2</source>
            <translation>%1, %2</translation>
        </message>
        <message>
            <source>%1, %2, %3</source>
            <translation>%1, %2, %3</translation>
        </message>
        <message>
            <source>revolution %1</source>
            <translation>оборот %1</translation>
        </message>
        <message>
            <source>Formulas of the step</source>
            <translation>Формулы этапа</translation>
        </message>
        <message>
            <source>Zone or section under the wheel</source>
            <translation>Зона или сечение под кругом</translation>
        </message>
        <message>
            <source>Place in the cycle</source>
            <translation>Место в цикле</translation>
        </message>
        <message>
            <source>Balance of the radius with its numbers</source>
            <translation>Баланс для радиуса с числами</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PhaseBar</name>
        <message>
            <source>Decided at four angles of the wheel, which runs out of true.</source>
            <translation>Решено при четырёх положениях круга, имеющего биение.</translation>
        </message>
        <message>
            <source>The upper end of the range must lie above the lower end: it begins at %1 mm and ends at %2 mm.</source>
            <translation>Диапазон должен возрастать: он начинается с %1 мм и кончается на %2 мм.</translation>
        </message>
        <message>
            <source>Stopped before there was a result. Press “Run”.</source>
            <translation>Остановлено до получения результата. Нажмите «Рассчитать».</translation>
        </message>
        <message>
            <source>Minimum stock per side to check; empty: half the maximum infeed below the given stock</source>
            <translation>Наименьший припуск на сторону; пусто: на половину наибольшей подачи на шаг ниже</translation>
        </message>
        <message>
            <source>Maximum stock per side to check; empty: half the maximum infeed above the given stock</source>
            <translation>Наибольший припуск на сторону; пусто: на половину наибольшей подачи на шаг выше</translation>
        </message>
        <message>
            <source>Run</source>
            <translation>Рассчитать</translation>
        </message>
        <message>
            <source>Check all stocks of the range; this also starts by itself after an edit</source>
            <translation>Проверить все припуски диапазона; после правки проверка идёт сама</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Остановить</translation>
        </message>
        <message>
            <source>Stop the run; the results so far are kept</source>
            <translation>Остановить расчёт; рассчитанное сохраняется</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>Что рассчитано</translation>
        </message>
        <message>
            <source>Progress of the check</source>
            <translation>Ход проверки</translation>
        </message>
    </context>
    <context>
        <name>PhaseChart</name>
        <message>
            <source>From stock per side, mm</source>
            <translation>Припуск на сторону от, мм</translation>
        </message>
        <message>
            <source>To stock per side, mm</source>
            <translation>Припуск на сторону до, мм</translation>
        </message>
        <message>
            <source>Steps of stage %1</source>
            <translation>Шагов ступени %1</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>Minimum deviation of the diameter, µm</source>
            <translation>Наименьшее отклонение диаметра, мкм</translation>
        </message>
        <message>
            <source>Maximum deviation of the diameter, µm</source>
            <translation>Наибольшее отклонение диаметра, мкм</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>maximum diameter</source>
            <translation>наибольший диаметр</translation>
        </message>
        <message>
            <source>minimum diameter</source>
            <translation>наименьший диаметр</translation>
        </message>
        <message>
            <source>tolerance band</source>
            <translation>поле допуска</translation>
        </message>
        <message>
            <source>unfit stocks</source>
            <translation>негодные припуски</translation>
        </message>
        <message>
            <source>stated stock</source>
            <translation>заданный припуск</translation>
        </message>
        <message>
            <source>Stock per side, mm</source>
            <translation>Припуск на сторону, мм</translation>
        </message>
        <message>
            <source>Deviation of the diameter from nominal, µm</source>
            <translation>Отклонение диаметра от номинала, мкм</translation>
        </message>
    </context>
    <context>
        <name>sparkout::SweepAxisBox</name>
        <message>
            <source>Choose an input to vary</source>
            <translation>Выберите, что варьировать</translation>
        </message>
        <message>
            <source>no second input</source>
            <translation>вторая величина не задана</translation>
        </message>
        <message>
            <source>%1 (not in this project)</source>
            <translation>%1 (нет в этом проекте)</translation>
        </message>
        <message>
            <source>First input varied</source>
            <translation>Первая варьируемая величина</translation>
        </message>
        <message>
            <source>Second input varied</source>
            <translation>Вторая варьируемая величина</translation>
        </message>
        <message>
            <source>First input: from</source>
            <translation>Первая величина: от</translation>
        </message>
        <message>
            <source>Second input: from</source>
            <translation>Вторая величина: от</translation>
        </message>
        <message>
            <source>First input: to</source>
            <translation>Первая величина: до</translation>
        </message>
        <message>
            <source>Second input: to</source>
            <translation>Вторая величина: до</translation>
        </message>
        <message>
            <source>First input: number of points</source>
            <translation>Первая величина: число точек</translation>
        </message>
        <message>
            <source>Second input: number of points</source>
            <translation>Вторая величина: число точек</translation>
        </message>
        <message>
            <source>First input: points at equal ratios instead of equal steps</source>
            <translation>Первая величина: точки в равных отношениях вместо равных шагов</translation>
        </message>
        <message>
            <source>Second input: points at equal ratios instead of equal steps</source>
            <translation>Вторая величина: точки в равных отношениях вместо равных шагов</translation>
        </message>
        <message>
            <source>points: </source>
            <translation>точек: </translation>
        </message>
        <message>
            <source>log</source>
            <comment>scale of a sweep</comment>
            <translation>лог</translation>
        </message>
    </context>
    <context>
        <name>SweepCurves</name>
        <message>
            <source>limit</source>
            <translation>предел</translation>
        </message>
        <message>
            <source>requirements met</source>
            <translation>выполнены все требования</translation>
        </message>
        <message>
            <source>current value</source>
            <translation>текущее значение</translation>
        </message>
    </context>
    <context>
        <name>SweepMap</name>
        <message>
            <source>limit of this result</source>
            <translation>предел этого результата</translation>
        </message>
        <message>
            <source>requirements met: edge</source>
            <translation>граница выполнения всех требований</translation>
        </message>
        <message>
            <source>current values</source>
            <translation>текущие значения</translation>
        </message>
        <message>
            <source>chosen point</source>
            <translation>выбранная точка</translation>
        </message>
    </context>
    <context>
        <name>SweepShown</name>
        <message>
            <source>refused (×)</source>
            <translation>отклонено (×)</translation>
        </message>
        <message>
            <source>does not reach size (▲)</source>
            <translation>не достигает размера (▲)</translation>
        </message>
        <message>
            <source>State</source>
            <translation>Состояние</translation>
        </message>
        <message>
            <source>%1: lower limit</source>
            <translation>%1: нижний предел</translation>
        </message>
        <message>
            <source>%1: upper limit</source>
            <translation>%1: верхний предел</translation>
        </message>
        <message>
            <source>%1: margin</source>
            <translation>%1: запас</translation>
        </message>
    </context>
    <context>
        <name>sparkout::SweepView</name>
        <message>
            <source>Point at a stock to read the steps, the time and the size of its cycle.</source>
            <translation>Наведите указатель на припуск, чтобы прочитать шаги, время и размер его цикла.</translation>
        </message>
        <message>
            <source>The inputs are refused; the stocks shown are those of the last valid inputs.</source>
            <translation>Исходные данные не приняты; проверка припусков — по последним верным.</translation>
        </message>
        <message>
            <source>Size against stock</source>
            <translation>Размер от припуска</translation>
        </message>
        <message>
            <source>Displayed content</source>
            <translation>Что показано</translation>
        </message>
        <message>
            <source>Results over one or two inputs, or, exactly, the size over the stock of the blank</source>
            <translation>Результаты в зависимости от одной или двух исходных величин или, точно, размер в зависимости от припуска заготовки</translation>
        </message>
        <message>
            <source>Inputs varied</source>
            <translation>Варьирование величин</translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation>Варьирование</translation>
        </message>
        <message>
            <source>%1, worst place</source>
            <translation>%1, худшее место</translation>
        </message>
        <message>
            <source> of %1</source>
            <translation> из %1</translation>
        </message>
        <message>
            <source>Point at a place to read its values; a click chooses it.</source>
            <translation>Наведите указатель на место, чтобы прочитать значения; щелчок выбирает его.</translation>
        </message>
        <message>
            <source>The inputs are refused; the sweep is that of the last valid inputs.</source>
            <translation>Исходные данные не приняты; варьирование — по последним верным.</translation>
        </message>
        <message>
            <source>What is the effect of a dull wheel, a soft tailstock, a longer dwell? Choose an input above to see every result over its range: one input gives curves, two give a map. Or start with the wheel&apos;s dullness.</source>
            <translation>Что даёт затупленный круг, податливая задняя бабка, более долгий выстой? Выберите выше исходную величину — и увидите любой результат в зависимости от неё: одна величина даёт кривые, две — карту. Или начните с затупления круга.</translation>
        </message>
        <message>
            <source>The sweep cannot be run:</source>
            <translation>Варьирование нельзя рассчитать:</translation>
        </message>
        <message>
            <source>This sweep takes a while: press “Run”. It can be stopped at any time and keeps the finished points.</source>
            <translation>Это варьирование займёт время: нажмите «Рассчитать». Его можно остановить в любой момент, сделанное сохраняется.</translation>
        </message>
        <message>
            <source>The cycle does not reach size at any point of the range.</source>
            <translation>Ни в одной точке этих пределов цикл не достигает размера.</translation>
        </message>
        <message>
            <source>No point has a result. Refused:</source>
            <translation>Ни в одной точке нет результата. Отклонено:</translation>
        </message>
        <message>
            <source>Nothing changes over this range: with the settings of this project, the model does not use this input.</source>
            <translation>В этих пределах ничего не меняется: при таких настройках проекта расчёт не зависит от этой величины.</translation>
        </message>
        <message>
            <source>Legend of the sweep</source>
            <translation>Легенда варьирования</translation>
        </message>
        <message>
            <source>State of the sweep</source>
            <translation>Состояние варьирования</translation>
        </message>
        <message>
            <source>Extent of the run</source>
            <translation>Что рассчитано</translation>
        </message>
        <message>
            <source>Values under the mouse, or of the point chosen</source>
            <translation>Значения под указателем или в выбранной точке</translation>
        </message>
        <message>
            <source>Progress of the sweep</source>
            <translation>Ход варьирования</translation>
        </message>
        <message>
            <source>Curves over the varied input</source>
            <translation>Кривые по варьируемой величине</translation>
        </message>
        <message>
            <source>Map over the two varied inputs</source>
            <translation>Карта по двум варьируемым величинам</translation>
        </message>
        <message>
            <source>Result shown</source>
            <translation>Показанный результат</translation>
        </message>
        <message>
            <source>The result that is shown over the varied inputs</source>
            <translation>Результат, показанный в зависимости от варьируемых величин</translation>
        </message>
        <message>
            <source>Values or margins</source>
            <translation>Значения или запасы</translation>
        </message>
        <message>
            <source>The values, or their distances from the limits: above 0 the requirement is met</source>
            <translation>Сами значения или их запас до предела: выше 0 требование выполнено</translation>
        </message>
        <message>
            <source>Point chosen</source>
            <translation>Выбранная точка</translation>
        </message>
        <message>
            <source>The point whose values can be applied; a click in the plot chooses one, too</source>
            <translation>Точка, значения которой можно применить; её выбирает и щелчок по графику</translation>
        </message>
        <message>
            <source>Run</source>
            <translation>Рассчитать</translation>
        </message>
        <message>
            <source>Run the points of the sweep; a quick one runs by itself</source>
            <translation>Рассчитать точки варьирования; небольшое считается само</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Остановить</translation>
        </message>
        <message>
            <source>Stop the sweep; the completed points are kept and shown</source>
            <translation>Закончить варьирование; сделанное сохраняется и показывается</translation>
        </message>
        <message>
            <source>Vary the dullness</source>
            <translation>Варьировать затупление</translation>
        </message>
        <message>
            <source>A sweep of the wheel&apos;s dullness from half to twice its value; can be undone</source>
            <translation>Варьирование затупления круга от половины до двойного значения; можно отменить</translation>
        </message>
        <message>
            <source>Apply these values</source>
            <translation>Применить эти значения</translation>
        </message>
        <message>
            <source>Use the inputs of the chosen point in this project; Undo restores the previous inputs</source>
            <translation>Подставить исходные данные выбранной точки в проект; отмена возвращает ваши</translation>
        </message>
        <message>
            <source>Values</source>
            <translation>Значения</translation>
        </message>
        <message>
            <source>Margins</source>
            <translation>Запасы</translation>
        </message>
        <message>
            <source>point </source>
            <translation>точка </translation>
        </message>
        <message>
            <source>no point</source>
            <translation>точка не выбрана</translation>
        </message>
    </context>
    <context>
        <name>sparkout::Tour</name>
        <message>
            <source>%1 of %2</source>
            <translation>%1 из %2</translation>
        </message>
    </context>
    <context>
        <name>sparkout::TourBalloon</name>
        <message>
            <source>Skip</source>
            <translation>Пропустить</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>Назад</translation>
        </message>
        <message>
            <source>Done</source>
            <translation>Готово</translation>
        </message>
        <message>
            <source>Next</source>
            <translation>Далее</translation>
        </message>
    </context>
    <context>
        <name>VerdictTable</name>
        <message>
            <source>Requirement of the drawing, the process or the machine on the cycle</source>
            <translation>Требование чертежа, процесса или станка к циклу</translation>
        </message>
        <message>
            <source>Worst value</source>
            <translation>Наихудшее значение</translation>
        </message>
        <message>
            <source>Allowed value</source>
            <translation>Допускаемое значение</translation>
        </message>
        <message>
            <source>Distance of the value from its limit; below 0 the limit is exceeded</source>
            <translation>Насколько значение отстоит от предела; меньше 0 — предел превышен</translation>
        </message>
        <message>
            <source>not known: strips uncut</source>
            <translation>неизвестно: остались полосы</translation>
        </message>
        <message>
            <source>met</source>
            <translation>выполнено</translation>
        </message>
        <message>
            <source>close to the limit</source>
            <translation>близко к пределу</translation>
        </message>
        <message>
            <source>not met</source>
            <translation>не выполнено</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>Предел</translation>
        </message>
        <message>
            <source>Margin</source>
            <translation>Запас</translation>
        </message>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>%1, µm</source>
            <translation>%1, мкм</translation>
        </message>
        <message>
            <source>Requirement</source>
            <translation>Требование</translation>
        </message>
        <message>
            <source>Whole part, µm</source>
            <translation>Вся деталь, мкм</translation>
        </message>
        <message>
            <source>Every pass</source>
            <translation>По всем проходам</translation>
        </message>
        <message>
            <source>Machine settings</source>
            <translation>Настройки станка</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>stage %1</source>
            <translation>ст. %1</translation>
        </message>
        <message>
            <source>Without a measured Ra this is the range of usual wheels.</source>
            <translation>Без измеренной Ra это диапазон для обычных кругов.</translation>
        </message>
        <message>
            <source>Ra, estimate</source>
            <translation>Ra, оценка</translation>
        </message>
        <message>
            <source>runout of the wheel not known</source>
            <translation>биение круга не известно</translation>
        </message>
        <message>
            <source>machine not known</source>
            <translation>без погрешности станка</translation>
        </message>
        <message>
            <source>not decided</source>
            <translation>не определено</translation>
        </message>
    </context>
    <context>
        <name>Judgement</name>
        <message>
            <source>the cycle does not end by itself</source>
            <translation>цикл не завершается сам</translation>
        </message>
        <message>
            <source>{name} by {amount} {unit}</source>
            <translation>{name} на {amount} {unit}</translation>
        </message>
        <message>
            <source>{name} by {amount}</source>
            <translation>{name} на {amount}</translation>
        </message>
        <message>
            <source>{bad} of {parts}</source>
            <translation>{bad} из {parts}</translation>
        </message>
        <message>
            <source>{bad} of {parts} (≤ {high} %)</source>
            <translation>{bad} из {parts} (≤ {high} %)</translation>
        </message>
        <message>
            <source>{bad} of {parts} ({low}…{high} %)</source>
            <translation>{bad} из {parts} ({low}…{high} %)</translation>
        </message>
        <message>
            <source>diameter</source>
            <translation>диаметр</translation>
        </message>
        <message>
            <source>Met, but measured parts differ from the prediction: {name}, {where}, by {value} {unit}</source>
            <translation>Выполнено, но измеренные детали расходятся с прогнозом: {name}, {where}, на {value} {unit}</translation>
        </message>
        <message>
            <source>Not computed: stopped</source>
            <translation>Не рассчитано: остановлено</translation>
        </message>
        <message>
            <source>Not computed: inputs refused</source>
            <translation>Не рассчитано: данные отклонены</translation>
        </message>
        <message>
            <source>Not met: {what}</source>
            <translation>Не выполнено: {what}</translation>
        </message>
        <message>
            <source>Unfit for {share} % of stocks: {what}</source>
            <translation>Не годен для {share} % припусков: {what}</translation>
        </message>
        <message>
            <source>Rejects in the batch: {bad}</source>
            <translation>Брак в партии: {bad}</translation>
        </message>
        <message>
            <source>Met, except {names}: not decided</source>
            <translation>Выполнено, но не определено: {names}</translation>
        </message>
        <message>
            <source>Met, Ppk of the batch too low: {low}…{high}</source>
            <translation>Выполнено, но Ppk партии мал: {low}…{high}</translation>
        </message>
        <message>
            <source>; Ppk {low}…{high}</source>
            <translation>; Ppk {low}…{high}</translation>
        </message>
        <message>
            <source>Met, close to the limit: {name}, {share} %</source>
            <translation>Выполнено, близко к пределу: {name}, {share} %</translation>
        </message>
        <message>
            <source>Fit for every stock; batch run in part</source>
            <translation>Годен для всех припусков; партия рассчитана не полностью</translation>
        </message>
        <message>
            <source>Fit for every stock; batch not run</source>
            <translation>Годен для всех припусков; партия не рассчитана</translation>
        </message>
        <message>
            <source>Fit for the batch: rejected {bad}</source>
            <translation>Годен для партии: брак {bad}</translation>
        </message>
        <message>
            <source>Fit for every stock</source>
            <translation>Годен для всех припусков</translation>
        </message>
        <message>
            <source>Nominal part only</source>
            <translation>Только номинальная деталь</translation>
        </message>
        <message>
            <source>Stocks: being decided</source>
            <translation>Припуски: проверяются</translation>
        </message>
        <message>
            <source>Stocks: not decided</source>
            <translation>Припуски: не проверены</translation>
        </message>
        <message>
            <source>Every stock per side {from}…{to} mm: fit</source>
            <translation>Все припуски на сторону {from}…{to} мм: годен</translation>
        </message>
        <message>
            <source>Stocks per side {from}…{to} mm: {share} % unfit</source>
            <translation>Припуски на сторону {from}…{to} мм: не годен для {share} %</translation>
        </message>
        <message>
            <source>Batch: being run</source>
            <translation>Партия: рассчитывается</translation>
        </message>
        <message>
            <source>Batch: not run</source>
            <translation>Партия: не рассчитана</translation>
        </message>
        <message>
            <source>Batch: rejected {bad}</source>
            <translation>Партия: брак {bad}</translation>
        </message>
        <message>
            <source>{name}: not calibrated</source>
            <translation>{name}: не откалибровано</translation>
        </message>
        <message>
            <source>{name}: input missing</source>
            <translation>{name}: не хватает исходных данных</translation>
        </message>
        <message>
            <source>{name}: machine not known</source>
            <translation>{name}: погрешность станка не задана</translation>
        </message>
    </context>
    <context>
        <name>Remedy</name>
        <message>
            <source>{feed} of stage {stage} {is}</source>
            <translation>Подача {feed} ступени {stage} {is}</translation>
        </message>
        <message>
            <source>Stock per side of stage {stage} {is} (stage {other}: {rest})</source>
            <translation>Припуск на сторону ступени {stage} {is} (ступени {other}: {rest})</translation>
        </message>
        <message>
            <source>Double strokes of spark-out {is}</source>
            <translation>Число двойных ходов выхаживания {is}</translation>
        </message>
        <message>
            <source>Revolutions of spark-out {is}</source>
            <translation>Число оборотов выхаживания {is}</translation>
        </message>
        <message>
            <source>One more stage after stage {stage}: {feed} {is}, stock per side {stock}</source>
            <translation>Ещё одна ступень после ступени {stage}: {feed} {is}, припуск на сторону {stock}</translation>
        </message>
        <message>
            <source>Spark-out as one more stage: double strokes {is}</source>
            <translation>Выхаживание дополнительной ступенью: число двойных ходов {is}</translation>
        </message>
        <message>
            <source>Spark-out as one more stage: revolutions {is}</source>
            <translation>Выхаживание дополнительной ступенью: число оборотов {is}</translation>
        </message>
        <message>
            <source>{time} s</source>
            <translation>{time} с</translation>
        </message>
        <message>
            <source>{time} min</source>
            <translation>{time} мин</translation>
        </message>
        <message>
            <source>the cycle takes {time}</source>
            <translation>время цикла {time}</translation>
        </message>
        <message>
            <source>in the same time</source>
            <translation>время прежнее</translation>
        </message>
        <message>
            <source>{change}: {cost}; {parts}</source>
            <translation>{change}: {cost}; {parts}</translation>
        </message>
        <message>
            <source>Run with {value}: nothing is close to its limit; the cycle takes {time}.</source>
            <translation>Расчёт при значении {value}: все требования выполнены с запасом; время цикла {time}.</translation>
        </message>
        <message>
            <source>Run with {value}: all requirements are met; the cycle takes {time}.</source>
            <translation>Расчёт при значении {value}: все требования выполнены; время цикла {time}.</translation>
        </message>
        <message>
            <source>{value}, one step nearer to the current {before}, is not enough.</source>
            <translation>Значения {value}, на шаг ближе к текущему {before}, недостаточно.</translation>
        </message>
        <message>
            <source>The cycle is fit for every stock per side of {from}…{to} mm: decided, not sampled.</source>
            <translation>Цикл годен для всех припусков на сторону {from}…{to} мм: решено точно, а не по выборке.</translation>
        </message>
        <message>
            <source>The cycle is fit for all {phases} stocks drawn at random within one infeed: with 95 % confidence it is unfit for at most {share} % of all stocks.</source>
            <translation>Цикл годен для всех {phases} случайных припусков в пределах подачи на шаг: с вероятностью 95 % не годен не более чем для {share} % всех припусков.</translation>
        </message>
        <message>
            <source>Each change helps for every stock within half an infeed of the stated one.</source>
            <translation>С каждым изменением цикл годен для всех припусков в пределах половины подачи на шаг от заданного.</translation>
        </message>
        <message>
            <source>Each change helps for the stocks tried within half an infeed of the stated one; under position control this is sampled, not decided.</source>
            <translation>С каждым изменением цикл годен для проверенных припусков в пределах половины подачи на шаг от заданного; при управлении по положению это проверено выборкой, а не решено.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting gives a sufficient margin: with {change}, nothing is close to its limit for the stated stock, but with a stock of {stock} mm the cycle does not end by itself.</source>
            <translation>Среди проверенных значений ни одна настройка не даёт запаса: при «{change}» для заданного припуска ничто не близко к пределу, но при припуске {stock} мм цикл сам не завершается.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting helps: with {change}, the cycle is fit for the stated stock, but with a stock of {stock} mm the cycle does not end by itself.</source>
            <translation>Среди проверенных значений не помогает ни одна настройка: при «{change}» для заданного припуска всё выполнено, но при припуске {stock} мм цикл сам не завершается.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting gives a sufficient margin: with {change}, nothing is close to its limit for the stated stock, but with a stock of {stock} mm “{second}” is not met.</source>
            <translation>Среди проверенных значений ни одна настройка не даёт запаса: при «{change}» для заданного припуска ничто не близко к пределу, но при припуске {stock} мм нарушено «{second}».</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting helps: with {change}, the cycle is fit for the stated stock, but with a stock of {stock} mm “{second}” is not met.</source>
            <translation>Среди проверенных значений не помогает ни одна настройка: при «{change}» для заданного припуска всё выполнено, но при припуске {stock} мм нарушено «{second}».</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting lets the cycle end by itself.</source>
            <translation>При проверенных значениях ни одна настройка в отдельности не даёт циклу завершиться.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting gives “{first}” a larger margin.</source>
            <translation>При проверенных значениях ни одна настройка в отдельности не прибавит запаса требованию «{first}».</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting meets “{first}” or brings it closer to its limit.</source>
            <translation>При проверенных значениях ни одна настройка в отдельности не устраняет и не уменьшает нарушение требования «{first}».</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting gives “{first}” a sufficient margin: it is largest with {change}.</source>
            <translation>При проверенных значениях ни одна настройка в отдельности не даёт требованию «{first}» достаточного запаса. {change} — запас наибольший.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting meets “{first}”: it comes closest to its limit with {change}.</source>
            <translation>При проверенных значениях ни одна настройка в отдельности не устраняет нарушение требования «{first}». {change} — нарушение наименьшее.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting gives “{first}” a sufficient margin: it is largest with {change}, where that of “{second}” is too small.</source>
            <translation>При проверенных значениях ни одна настройка в отдельности не даёт требованию «{first}» достаточного запаса. {change} — запас наибольший, но мал запас требования «{second}».</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting meets “{first}”: it comes closest to its limit with {change}, where “{second}” is not met.</source>
            <translation>При проверенных значениях ни одна настройка в отдельности не устраняет нарушение требования «{first}». {change} — нарушение наименьшее, но нарушено требование «{second}».</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting helps: with {change}, the cycle ends by itself, but “{second}” is not met.</source>
            <translation>При проверенных значениях изменение одной настройки не помогает: {change} — цикл завершается, но нарушено требование «{second}».</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting gives a sufficient margin: with {change}, that of “{first}” is sufficient, but that of “{second}” is not.</source>
            <translation>При проверенных значениях изменение одной настройки запаса не даёт: {change} — у требования «{first}» запас есть, у требования «{second}» нет.</translation>
        </message>
        <message>
            <source>No single setting helps. “{first}” asks for less ({change}), “{second}” for more.</source>
            <translation>Одной настройкой не исправить. «{first}» требует меньше ({change}), «{second}» — больше.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting meets all requirements: with {change}, “{first}” is met, but “{second}” is still not met.</source>
            <translation>При проверенных значениях изменение одной настройки не устраняет всех нарушений: {change} — требование «{first}» выполнено, «{second}» по-прежнему нарушено.</translation>
        </message>
        <message>
            <source>With the current feed the added stage does not help.</source>
            <translation>С текущей подачей дополнительная ступень не помогает.</translation>
        </message>
        <message>
            <source>Without this stage the margin is too small.</source>
            <translation>Без этой ступени запас слишком мал.</translation>
        </message>
        <message>
            <source>Without this stage the cycle is unfit.</source>
            <translation>Без этой ступени цикл не годен.</translation>
        </message>
        <message>
            <source>With the current value the margin is too small.</source>
            <translation>При текущем значении запас слишком мал.</translation>
        </message>
        <message>
            <source>The current value is not enough.</source>
            <translation>Текущего значения недостаточно.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting gives a sufficient margin: with {change}, nothing is close to its limit, but the change brings a warning.</source>
            <translation>При проверенных значениях изменение одной настройки запаса не даёт: {change} — все требования выполнены с запасом, но появляется предупреждение.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting helps: with {change}, all requirements are met, but the change brings a warning.</source>
            <translation>При проверенных значениях изменение одной настройки не помогает: {change} — все требования выполнены, но появляется предупреждение.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting gives a sufficient margin: with {change}, nothing is close to its limit, but one more stage ends without a step.</source>
            <translation>При проверенных значениях изменение одной настройки запаса не даёт: {change} — все требования выполнены с запасом, но ещё одна ступень остаётся без хода.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting helps: with {change}, all requirements are met, but one more stage ends without a step.</source>
            <translation>При проверенных значениях изменение одной настройки не помогает: {change} — все требования выполнены, но ещё одна ступень остаётся без хода.</translation>
        </message>
        <message>
            <source>The time was up after {tried} of {all} settings.</source>
            <translation>Время поиска вышло; проверено настроек: {tried} из {all}.</translation>
        </message>
        <message>
            <source>Stopped after {tried} of {all} settings.</source>
            <translation>Поиск остановлен; проверено настроек: {tried} из {all}.</translation>
        </message>
        <message>
            <source>No single setting helps. “{first}” asks for more ({change}), “{second}” for less.</source>
            <translation>Одной настройкой не исправить. «{first}» требует больше ({change}), «{second}» — меньше.</translation>
        </message>
        <message>
            <source>No single setting helps. “{first}” asks for one more stage ({change}), “{second}” for none.</source>
            <translation>Одной настройкой не исправить. «{first}» требует дополнительной ступени ({change}), «{second}» её не допускает.</translation>
        </message>
        <message>
            <source>= {value} ({interval})</source>
            <translation>= {value} ({interval})</translation>
        </message>
        <message>
            <source>for every stock</source>
            <translation>для всех припусков</translation>
        </message>
        <message>
            <source>for {phases} stocks</source>
            <translation>для {phases} припусков</translation>
        </message>
        <message>
            <source>{change}, with {feed} of stage 1 = {value}</source>
            <translation>{change}, подача {feed} ступени 1 = {value}</translation>
        </message>
        <message>
            <source>Starting cycle</source>
            <translation>Исходный цикл</translation>
        </message>
        <message>
            <source>A cycle made for the given part, wheel and machine: nothing is close to its limit; it takes {time}.</source>
            <translation>Цикл, составленный для детали, круга и станка как они есть: все требования выполнены с запасом; его время {time}.</translation>
        </message>
        <message>
            <source>A cycle made for the given part, wheel and machine: all requirements are met; it takes {time}.</source>
            <translation>Цикл, составленный для детали, круга и станка как они есть: все требования выполнены; его время {time}.</translation>
        </message>
        <message>
            <source>It has stages, work speed, overruns and dwells of its own.</source>
            <translation>У него свои ступени, частота вращения заготовки, перебеги и выстои.</translation>
        </message>
        <message>
            <source>, {bad} of {parts} rejected</source>
            <translation>, брак {bad} из {parts}</translation>
        </message>
        <message>
            <source>This applies to all {values} values of {interval} that can be set.</source>
            <translation>То же при всех задаваемых значениях {interval} (их {values}).</translation>
        </message>
        <message>
            <source>Of {parts} parts of the batch drawn for this check, {bad} are rejected: with 95 % confidence at most {share} % of all parts are.</source>
            <translation>Из {parts} случайных деталей партии не годны {bad}: с вероятностью 95 % — не более {share} % всех.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting gives a sufficient margin: with {change} the margin is sufficient, but not with the values next to it.</source>
            <translation>При проверенных значениях изменение одной настройки запаса не даёт: {change} — запас есть, но при соседних значениях его нет.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting helps: with {change} all requirements are met, but not with the values next to it.</source>
            <translation>При проверенных значениях изменение одной настройки не помогает: {change} — все требования выполнены, но при соседних значениях нет.</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting helps: with {change} all requirements are met for every stock, but too many parts of the batch are rejected: “{second}” is not met.</source>
            <translation>При проверенных значениях изменение одной настройки не помогает: {change} — все требования выполнены для всех припусков, но в партии слишком много брака: нарушено «{second}».</translation>
        </message>
        <message>
            <source>Among the values tried, no single setting helps: with {change} all requirements are met for every stock, but the cycle does not end by itself for too many parts of the batch.</source>
            <translation>При проверенных значениях изменение одной настройки не помогает: {change} — все требования выполнены для всех припусков, но для слишком многих деталей партии цикл сам не завершается.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::RemedySection</name>
        <message>
            <source>Apply the change</source>
            <translation>Применить изменение</translation>
        </message>
        <message>
            <source>Change that helps</source>
            <translation>Изменение, которое поможет</translation>
        </message>
        <message>
            <source>Ways to a larger margin</source>
            <translation>Что добавит запаса</translation>
        </message>
        <message>
            <source>Possible remedies</source>
            <translation>Что поможет</translation>
        </message>
        <message>
            <source>Apply</source>
            <translation>Применить</translation>
        </message>
        <message>
            <source>Apply the change: %1</source>
            <translation>Применить изменение: %1</translation>
        </message>
        <message>
            <source>%1 of %2 settings tried.</source>
            <translation>Проверено настроек: %1 из %2.</translation>
        </message>
        <message>
            <source>Settings that help: %1; shown are those that cost least.</source>
            <translation>Подходящих настроек: %1; показаны наименее затратные.</translation>
        </message>
        <message>
            <source>Settings tried</source>
            <translation>Что проверено</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Остановить</translation>
        </message>
        <message>
            <source>Stop looking for changes that help</source>
            <translation>Остановить поиск изменений</translation>
        </message>
    </context>
    <context>
        <name>sparkout::VerdictPanel</name>
        <message>
            <source>The inputs are refused; the numbers are those of the last valid inputs.</source>
            <translation>Исходные данные не приняты; числа — по последним верным.</translation>
        </message>
        <message>
            <source>The inputs are refused:</source>
            <translation>Исходные данные не приняты:</translation>
        </message>
        <message>
            <source>No result yet.</source>
            <translation>Результата ещё нет.</translation>
        </message>
        <message>
            <source>Part as stated:</source>
            <translation>Заданная деталь:</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>State of the verdict</source>
            <translation>Состояние заключения</translation>
        </message>
        <message>
            <source>Machining time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>End of the cycle</source>
            <translation>Конец цикла</translation>
        </message>
        <message>
            <source>Verdict on the drawing</source>
            <translation>Заключение по чертежу</translation>
        </message>
        <message>
            <source>Requirements of the drawing</source>
            <translation>Требования чертежа</translation>
        </message>
        <message numerus="yes">
            <source>%n fields contain invalid entries; the verdict is based on their last valid values.</source>
            <translation>
                <numerusform>В %n поле стоит непринятый текст; заключение — по прежнему значению.</numerusform>
                <numerusform>В %n полях стоит непринятый текст; заключение — по прежним значениям.</numerusform>
                <numerusform>В %n полях стоит непринятый текст; заключение — по прежним значениям.</numerusform>
            </translation>
        </message>
        <message>
            <source>Fields with invalid entries</source>
            <translation>Поля с непринятым текстом</translation>
        </message>
        <message>
            <source>Scope of the table</source>
            <translation>К чему относится таблица</translation>
        </message>
        <message>
            <source>Where the value comes from</source>
            <translation>Откуда берётся значение</translation>
        </message>
        <message>
            <source>Requirements that are not checked</source>
            <translation>Требования, которые не проверяются</translation>
        </message>
        <message>
            <source>Not checked: requirements or other inputs are missing. Still needed:</source>
            <translation>Не проверено: не заданы требования или другие данные. Ещё нужны:</translation>
        </message>
        <message>
            <source>Verdict over the stocks</source>
            <translation>Заключение по припускам</translation>
        </message>
        <message>
            <source>Verdict on the batch</source>
            <translation>Заключение по партии</translation>
        </message>
        <message>
            <source>%1 (before the last edit)</source>
            <translation>%1 (до последней правки)</translation>
        </message>
    </context>
    <context>
        <name>sparkout::VersionsDialog</name>
        <message>
            <source>Earlier versions</source>
            <translation>Прежние версии</translation>
        </message>
        <message>
            <source>No earlier version of “%1” is kept yet.</source>
            <translation>Прежних версий «%1» пока нет.</translation>
        </message>
        <message>
            <source>Versions of “%1” that a save has replaced. The chosen one is opened as a copy; the file stays as it is.</source>
            <translation>Версии «%1», которые заменило сохранение. Выбранная откроется как копия; сам файл не изменится.</translation>
        </message>
        <message>
            <source>Replaced at</source>
            <translation>Заменена</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Размер</translation>
        </message>
        <message>
            <source>File</source>
            <translation>Файл</translation>
        </message>
        <message>
            <source>&amp;Open a copy</source>
            <translation>&amp;Открыть копию</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ViewTabs</name>
        <message>
            <source>&amp;Detach into a separate window</source>
            <translation>&amp;Отделить в своё окно</translation>
        </message>
        <message>
            <source>Detach the view into a separate window (also: double click on its tab). It returns when the window is closed.</source>
            <translation>Отделить вид в своё окно (или двойным щелчком по его вкладке). Он вернётся, когда окно закроют.</translation>
        </message>
        <message>
            <source>The last view stays in the main window.</source>
            <translation>Последний вид остаётся в главном окне.</translation>
        </message>
        <message>
            <source>%1 — Sparkout</source>
            <translation>%1 — Sparkout</translation>
        </message>
        <message>
            <source>Views</source>
            <translation>Виды</translation>
        </message>
        <message>
            <source>Detach the view</source>
            <translation>Отделить вид</translation>
        </message>
    </context>
    <context>
        <name>ComplianceCurves</name>
        <message>
            <source>Compliance γ, nm/N</source>
            <translation>Податливость γ, нм/Н</translation>
        </message>
        <message>
            <source>wheel head</source>
            <translation>шлифовальная бабка</translation>
        </message>
        <message>
            <source>headstock</source>
            <translation>передняя бабка</translation>
        </message>
        <message>
            <source>tailstock</source>
            <translation>задняя бабка</translation>
        </message>
        <message>
            <source>bending</source>
            <translation>изгиб</translation>
        </message>
        <message>
            <source>taken by steady rests</source>
            <translation>снимают люнеты</translation>
        </message>
        <message>
            <source>bending of the quill</source>
            <translation>изгиб оправки</translation>
        </message>
        <message>
            <source>γ, with the steady rests</source>
            <translation>γ, с люнетами</translation>
        </message>
        <message>
            <source>γ</source>
            <translation>γ</translation>
        </message>
        <message>
            <source>γ of the zones used in the run</source>
            <translation>γ зон, принятая в расчёте</translation>
        </message>
        <message>
            <source>γ of the sections used in the run</source>
            <translation>γ сечений, принятая в расчёте</translation>
        </message>
        <message>
            <source>From the headstock end of the ground length, mm</source>
            <translation>От начала шлифуемой длины со стороны передней бабки, мм</translation>
        </message>
        <message>
            <source>γ, mm/N</source>
            <translation>γ, мм/Н</translation>
        </message>
        <message>
            <source>%1, mm/N</source>
            <translation>%1, мм/Н</translation>
        </message>
        <message>
            <source>At %1 mm: γ %2 nm/N = %3</source>
            <translation>На %1 мм: γ %2 нм/Н = %3</translation>
        </message>
        <message>
            <source>%1, nm/N</source>
            <translation>%1, нм/Н</translation>
        </message>
    </context>
    <context>
        <name>LimitChart</name>
        <message>
            <source>nearest to its feed limit: %1, %2</source>
            <translation>ближе всего к пределу подачи: %1, %2</translation>
        </message>
        <message>
            <source> (%1 used)</source>
            <translation> (занято %1)</translation>
        </message>
        <message>
            <source>%1: stock left %2 µm, actual feed %3 µm, width %4 mm</source>
            <translation>%1: припуск %2 мкм, фактическая подача %3 мкм, ширина %4 мм</translation>
        </message>
        <message>
            <source>Allowed feed, µm: %1</source>
            <translation>Допустимая подача, мкм: %1</translation>
        </message>
        <message>
            <source>Actual feed, µm per pass</source>
            <translation>Факт. подача, мкм/проход</translation>
        </message>
        <message>
            <source>Actual feed, µm per revolution</source>
            <translation>Факт. подача, мкм/об</translation>
        </message>
        <message>
            <source>stage</source>
            <translation>ступень</translation>
        </message>
        <message>
            <source>double stroke</source>
            <translation>двойной ход</translation>
        </message>
        <message>
            <source>revolution</source>
            <translation>оборот</translation>
        </message>
        <message>
            <source>stock left, µm</source>
            <translation>оставшийся припуск, мкм</translation>
        </message>
        <message>
            <source>actual feed, µm</source>
            <translation>фактическая подача, мкм</translation>
        </message>
        <message>
            <source>width of cut, mm</source>
            <translation>ширина шлифования, мм</translation>
        </message>
        <message>
            <source>limit: %1, µm</source>
            <translation>предел: %1, мкм</translation>
        </message>
        <message>
            <source>stepless limit, µm</source>
            <translation>предел бесступенчатого цикла, мкм</translation>
        </message>
        <message>
            <source>binding</source>
            <translation>ограничивает</translation>
        </message>
        <message>
            <source>machine&apos;s feed</source>
            <translation>подача станка</translation>
        </message>
        <message>
            <source>accuracy</source>
            <translation>точность</translation>
        </message>
        <message>
            <source>binds: %1</source>
            <translation>ограничивает: %1</translation>
        </message>
        <message>
            <source>accuracy, proved</source>
            <translation>точность, доказано</translation>
        </message>
        <message>
            <source>accuracy at steady feed, estimate</source>
            <translation>точность при постоянной подаче, оценка</translation>
        </message>
        <message>
            <source>mm/min</source>
            <translation>мм/мин</translation>
        </message>
        <message>
            <source>runout in every pass, as published (22)</source>
            <translation>биение в каждом проходе по опубликованной формуле (22)</translation>
        </message>
        <message>
            <source>programmed feed, µm</source>
            <translation>программная подача, мкм</translation>
        </message>
        <message>
            <source>actual</source>
            <comment>legend: feed</comment>
            <translation>факт</translation>
        </message>
        <message>
            <source>Stock left after the cut, µm</source>
            <translation>Оставшийся припуск после прохода, мкм</translation>
        </message>
        <message>
            <source>machine&apos;s maximum feed</source>
            <translation>наибольшая подача станка</translation>
        </message>
        <message>
            <source>stepless limit</source>
            <translation>предел цикла</translation>
        </message>
        <message>
            <source>≈ accuracy</source>
            <translation>≈ точность</translation>
        </message>
        <message>
            <source>runout (22)</source>
            <translation>биение (22)</translation>
        </message>
        <message>
            <source>programmed</source>
            <translation>программа</translation>
        </message>
        <message>
            <source>machine&apos;s feed</source>
            <comment>legend</comment>
            <translation>станок</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PartPlot</name>
        <message>
            <source>From the headstock end of the ground length, mm</source>
            <translation>От начала шлифуемой длины со стороны передней бабки, мм</translation>
        </message>
        <message>
            <source>Radius from
target, µm</source>
            <translation>Радиус от
целевого, мкм</translation>
        </message>
        <message>
            <source>axis of rotation</source>
            <translation>ось вращения</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PlotView</name>
        <message>
            <source>The inputs are refused; the curves are those of the last valid inputs.</source>
            <translation>Исходные данные не приняты; кривые — по последним верным.</translation>
        </message>
        <message>
            <source>The inputs are refused:</source>
            <translation>Исходные данные не приняты:</translation>
        </message>
        <message>
            <source>No result yet.</source>
            <translation>Результата ещё нет.</translation>
        </message>
        <message>
            <source>The project is not complete. Still needed:</source>
            <translation>Проект не заполнен. Ещё нужны:</translation>
        </message>
        <message>
            <source>The pale curves are those of the last complete inputs.</source>
            <translation>Бледные кривые — по последним полным данным.</translation>
        </message>
    </context>
    <context>
        <name>FeedsChart</name>
        <message>
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>Double strokes done</source>
            <translation>Выполнено двойных ходов</translation>
        </message>
        <message>
            <source>Revolutions done</source>
            <translation>Выполнено оборотов</translation>
        </message>
        <message>
            <source>zone</source>
            <translation>зона</translation>
        </message>
        <message>
            <source>section</source>
            <translation>сечение</translation>
        </message>
        <message>
            <source>stage</source>
            <translation>ступень</translation>
        </message>
        <message>
            <source>double stroke</source>
            <translation>двойной ход</translation>
        </message>
        <message>
            <source>revolution</source>
            <translation>оборот</translation>
        </message>
        <message>
            <source>step</source>
            <translation>этап</translation>
        </message>
        <message>
            <source>pass of the step</source>
            <translation>проход этапа</translation>
        </message>
        <message>
            <source>radius no.</source>
            <translation>№ радиуса</translation>
        </message>
        <message>
            <source>%1: from</source>
            <comment>time</comment>
            <translation>%1: от</translation>
        </message>
        <message>
            <source>%1: to</source>
            <comment>time</comment>
            <translation>%1: до</translation>
        </message>
        <message>
            <source>%1: minimum</source>
            <translation>%1: наименьшее</translation>
        </message>
        <message>
            <source>%1: maximum</source>
            <translation>%1: наибольшее</translation>
        </message>
        <message>
            <source>Feed, µm
per revolution</source>
            <translation>Подача, мкм
на оборот</translation>
        </message>
        <message>
            <source>Feed, µm per
double stroke</source>
            <translation>Подача,
мкм/дв. ход</translation>
        </message>
        <message>
            <source>Feed, µm
per pass</source>
            <translation>Подача,
мкм/проход</translation>
        </message>
        <message>
            <source>Normal
force, N</source>
            <translation>Нормальная
сила, Н</translation>
        </message>
        <message>
            <source>Axial feed,
mm/min</source>
            <translation>Продольная подача,
мм/мин</translation>
        </message>
        <message>
            <source>Accumulated
feed, µm</source>
            <translation>Накопленная
подача, мкм</translation>
        </message>
        <message>
            <source>Radius above
target, µm</source>
            <translation>Радиус сверх
заданного, мкм</translation>
        </message>
        <message>
            <source>%1 (gauge)</source>
            <translation>%1 (ПАК)</translation>
        </message>
        <message>
            <source>Feed, µm</source>
            <translation>Подача, мкм</translation>
        </message>
        <message>
            <source>Σ feed,
µm</source>
            <translation>Σ подач,
мкм</translation>
        </message>
        <message>
            <source>Axial,
mm/min</source>
            <translation>Продольная,
мм/мин</translation>
        </message>
        <message>
            <source>Force, N</source>
            <translation>Сила, Н</translation>
        </message>
        <message>
            <source>Radius,
µm</source>
            <translation>Радиус,
мкм</translation>
        </message>
        <message>
            <source>µm</source>
            <translation>мкм</translation>
        </message>
        <message>
            <source>mm/min</source>
            <translation>мм/мин</translation>
        </message>
        <message>
            <source>N</source>
            <translation>Н</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>stage %1</source>
            <translation>ступень %1</translation>
        </message>
        <message>
            <source>st. %1</source>
            <comment>stage, short</comment>
            <translation>ст. %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::OverviewView</name>
        <message>
            <source>Add a batch…</source>
            <translation>Добавить партию…</translation>
        </message>
        <message>
            <source>This project describes no batch. With a batch of parts whose stock, runout and wheel scatter, the scatter of the sizes and the number of good parts are shown here.</source>
            <translation>В проекте нет партии. Партия деталей, у которых рассеиваются припуск, биение и состояние круга, покажет здесь рассеяние размеров и число годных деталей.</translation>
        </message>
        <message>
            <source>The batch has not been run. The scatter of its sizes and the number of good parts will be shown here.</source>
            <translation>Партия ещё не рассчитана: здесь будут рассеяние её размеров и число годных деталей.</translation>
        </message>
        <message>
            <source>Run the batch…</source>
            <translation>Рассчитать партию…</translation>
        </message>
        <message>
            <source>No part of the batch has a size to show.</source>
            <translation>Ни у одной детали партии нет размера.</translation>
        </message>
        <message>
            <source>The batch consists of corner parts: they are not a sample and have no quartiles.</source>
            <translation>Партия — крайние сочетания: это не выборка, квартилей у неё нет.</translation>
        </message>
        <message>
            <source>To the batch…</source>
            <translation>К партии…</translation>
        </message>
        <message>
            <source>The cycle is too long to be recorded step by step: fewer radii or sections help.</source>
            <translation>Цикл слишком длинный для записи по этапам: помогут меньше радиусов или сечений.</translation>
        </message>
        <message>
            <source>current</source>
            <comment>run</comment>
            <translation>текущий</translation>
        </message>
        <message>
            <source>No run is kept yet. Its time and margin will be shown here beside those of the current run.</source>
            <translation>Запомненных расчётов ещё нет: здесь будут их время и запас рядом с текущим расчётом.</translation>
        </message>
        <message>
            <source>Keep this run</source>
            <translation>Запомнить этот расчёт</translation>
        </message>
        <message>
            <source>Overview</source>
            <translation>Обзор</translation>
        </message>
        <message>
            <source>Point at a bar to read its value; a click leads to its view. By keyboard: arrows, Enter.</source>
            <translation>Значение столбца — под указателем; щелчок ведёт к виду. С клавиатуры: стрелки, Enter.</translation>
        </message>
        <message>
            <source>The inputs have changed since the batch was run.</source>
            <translation>Исходные данные изменены после расчёта партии.</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <comment>view, chart</comment>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Legend of the overview</source>
            <translation>Условные обозначения обзора</translation>
        </message>
        <message>
            <source>State of the overview</source>
            <translation>Состояние обзора</translation>
        </message>
        <message>
            <source>Values under the mouse</source>
            <translation>Значения под указателем</translation>
        </message>
        <message>
            <source>Charts of the overview</source>
            <translation>Диаграммы обзора</translation>
        </message>
    </context>
    <context>
        <name>sparkout::OverviewTile</name>
        <message>
            <source>Back to all charts</source>
            <translation>Назад ко всем диаграммам</translation>
        </message>
        <message>
            <source>Enlarge: %1</source>
            <translation>Увеличить: %1</translation>
        </message>
        <message>
            <source>Back to all charts (Esc)</source>
            <translation>Назад ко всем диаграммам (Esc)</translation>
        </message>
        <message>
            <source>Enlarge this chart to the whole page</source>
            <translation>Увеличить диаграмму на всю страницу</translation>
        </message>
        <message>
            <source>Legend: %1</source>
            <translation>Условные обозначения: %1</translation>
        </message>
    </context>
    <context>
        <name>OverviewCharts</name>
        <message>
            <source>Time by stage and step</source>
            <translation>Время по ступеням и этапам</translation>
        </message>
        <message>
            <source>Removed by stage and step</source>
            <translation>Снятый припуск по ступеням и этапам</translation>
        </message>
        <message>
            <source>Components of the diameter deviations</source>
            <translation>Из чего складываются отклонения диаметра</translation>
        </message>
        <message>
            <source>Limits used up</source>
            <translation>Использование допусков и пределов</translation>
        </message>
        <message>
            <source>Batch: mean diameters</source>
            <translation>Партия: средние диаметры</translation>
        </message>
        <message>
            <source>Batch: good and rejected parts</source>
            <translation>Партия: годные и негодные детали</translation>
        </message>
        <message>
            <source>Kept runs: time and margin</source>
            <translation>Запомненные расчёты: время и запас</translation>
        </message>
        <message>
            <source>Stage</source>
            <translation>Ступень</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>Stage %1</source>
            <translation>Ступень %1</translation>
        </message>
        <message>
            <source>The cycle is too long to be recorded step by step.</source>
            <translation>Цикл слишком длинный для записи по этапам.</translation>
        </message>
        <message>
            <source>%1 of %2 stages: the longest ones.</source>
            <translation>Ступени: %1 из %2 — самые продолжительные.</translation>
        </message>
        <message>
            <source>%1 of %2 sections: the ends, the gauge's and the one whose diameter is nearest to its limit.</source>
            <translation>Сечения: %1 из %2 — крайние, сечение прибора и то, диаметр которого ближе всего к пределу.</translation>
        </message>
        <message>
            <source>Stage and zone</source>
            <translation>Ступень и зона</translation>
        </message>
        <message>
            <source>Removed per side</source>
            <translation>Снято на сторону</translation>
        </message>
        <message>
            <source>Stage %1, %2</source>
            <comment>number, zone</comment>
            <translation>Ступень %1, %2</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Диаметр</translation>
        </message>
        <message>
            <source>From nominal</source>
            <translation>От номинала</translation>
        </message>
        <message>
            <source>tolerance band</source>
            <translation>поле допуска</translation>
        </message>
        <message>
            <source>deviation, the sum</source>
            <translation>отклонение, сумма</translation>
        </message>
        <message>
            <source>gauge at the end</source>
            <translation>прибор в конце</translation>
        </message>
        <message>
            <source>zone against the gauge</source>
            <translation>зона относительно прибора</translation>
        </message>
        <message>
            <source>section against the gauge</source>
            <translation>сечение относительно прибора</translation>
        </message>
        <message>
            <source>S%1</source>
            <comment>section, in little room</comment>
            <translation>С%1</translation>
        </message>
        <message>
            <source>spread in the section</source>
            <translation>непостоянство в сечении</translation>
        </message>
        <message>
            <source>min</source>
            <comment>diameter</comment>
            <translation>наим.</translation>
        </message>
        <message>
            <source>max</source>
            <comment>diameter</comment>
            <translation>наиб.</translation>
        </message>
        <message>
            <source>Requirement</source>
            <translation>Требование</translation>
        </message>
        <message>
            <source>Share of tolerance or limit</source>
            <translation>Доля допуска или предела</translation>
        </message>
        <message>
            <source>limit</source>
            <translation>предел</translation>
        </message>
        <message numerus="yes">
            <source>%n ranges of the machine are met and not drawn.</source>
            <translation>
                <numerusform>%n диапазон станка соблюдён и не показан.</numerusform>
                <numerusform>%n диапазона станка соблюдены и не показаны.</numerusform>
                <numerusform>%n диапазонов станка соблюдены и не показаны.</numerusform>
            </translation>
        </message>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>Box: the middle half of the parts; its line and the figure at the box are the median; whiskers: the smallest and the largest part.</source>
            <translation>Прямоугольник — средняя половина деталей, черта в нём и число у него — медиана; «усы» — до наименьшей и наибольшей детали.</translation>
        </message>
        <message>
            <source>The quartiles are exact to within a bin.</source>
            <translation>Квартили — с точностью до интервала гистограммы.</translation>
        </message>
        <message>
            <source>%1 of %2 sections, where the Ppk is lowest.</source>
            <translation>Сечения: %1 из %2, где Ppk наименьший.</translation>
        </message>
        <message>
            <source>Batch</source>
            <translation>Партия</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Детали</translation>
        </message>
        <message>
            <source>good</source>
            <translation>годные</translation>
        </message>
        <message>
            <source>out of tolerance</source>
            <translation>вне допуска</translation>
        </message>
        <message>
            <source>size not reached</source>
            <translation>размер не достигнут</translation>
        </message>
        <message>
            <source>%1 of %2
good</source>
            <comment>numbers of parts</comment>
            <translation>%1 из %2
годны</translation>
        </message>
        <message>
            <source>Run</source>
            <translation>Расчёт</translation>
        </message>
        <message>
            <source>Machining time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>Minimum margin</source>
            <translation>Наименьший запас</translation>
        </message>
        <message>
            <source>machining time</source>
            <translation>основное время</translation>
        </message>
        <message>
            <source>minimum margin</source>
            <translation>наименьший запас</translation>
        </message>
        <message>
            <source>Margin of the decided requirement nearest to its limit; below 0 if one is not met.</source>
            <translation>Запас — у ближайшего к пределу из определённых требований; ниже 0, если требование не выполнено.</translation>
        </message>
        <message>
            <source>The current run and the newest %1 of the %2 kept runs.</source>
            <translation>Текущий расчёт и последние %1 из %2 запомненных.</translation>
        </message>
    </context>
    <context>
        <name>BarChart</name>
        <message>
            <source>minimum</source>
            <translation>наименьший</translation>
        </message>
        <message>
            <source>lower quartile</source>
            <translation>нижний квартиль</translation>
        </message>
        <message>
            <source>median</source>
            <translation>медиана</translation>
        </message>
        <message>
            <source>upper quartile</source>
            <translation>верхний квартиль</translation>
        </message>
        <message>
            <source>maximum</source>
            <translation>наибольший</translation>
        </message>
    </context>
    <context>
        <name>Calculation</name>
        <message>
            <source>a closing bracket has no opening one</source>
            <translation>у закрывающей скобки нет открывающей</translation>
        </message>
        <message>
            <source>an operator is missing before “%1”</source>
            <translation>перед «%1» нет знака действия</translation>
        </message>
        <message>
            <source>the result is too large or too small</source>
            <translation>результат слишком велик или слишком мал</translation>
        </message>
        <message>
            <source>division by zero</source>
            <translation>деление на ноль</translation>
        </message>
        <message>
            <source>a bracket is not closed</source>
            <translation>скобка не закрыта</translation>
        </message>
        <message>
            <source>a number is missing before “%1”</source>
            <translation>перед «%1» нет числа</translation>
        </message>
        <message>
            <source>a number is missing at the end</source>
            <translation>в конце нет числа</translation>
        </message>
        <message>
            <source>“%1” is not a number</source>
            <translation>«%1» — не число</translation>
        </message>
    </context>
    <context>
        <name>ListPaste</name>
        <message>
            <source>there are no rows below the headings</source>
            <translation>под заголовками нет строк</translation>
        </message>
        <message numerus="yes">
            <source>%n column(s) too many from the selected cell on</source>
            <translation>
                <numerusform>лишний %n столбец, считая от выбранной ячейки</numerusform>
                <numerusform>лишние %n столбца, считая от выбранной ячейки</numerusform>
                <numerusform>лишних %n столбцов, считая от выбранной ячейки</numerusform>
            </translation>
        </message>
        <message>
            <source>there would be %1 rows; allowed: %2</source>
            <translation>получилось бы строк: %1; допускается: %2</translation>
        </message>
        <message>
            <source>%1 %2, %3: %4</source>
            <comment>stage 2, stock: reason</comment>
            <translation>%1 %2, %3: %4</translation>
        </message>
    </context>
    <context>
        <name>PastedNumbers</name>
        <message>
            <source>“%1” is out of range</source>
            <translation>«%1» вне допустимых пределов</translation>
        </message>
        <message>
            <source>“%1” is not a number</source>
            <translation>«%1» — не число</translation>
        </message>
        <message>
            <source>%1; allowed: %2</source>
            <translation>%1; допускается: %2</translation>
        </message>
        <message>
            <source>row %1, column %2</source>
            <translation>строка %1, столбец %2</translation>
        </message>
        <message>
            <source>row %1</source>
            <translation>строка %1</translation>
        </message>
        <message>
            <source>not pasted: %1: %2</source>
            <comment>place: reason</comment>
            <translation>не вставлено: %1: %2</translation>
        </message>
    </context>
    <context>
        <name>StockFit</name>
        <message>
            <source>%1 %2 on diameter</source>
            <translation>%1 %2 на диаметр</translation>
        </message>
        <message>
            <source>Fit the stocks: the first stage takes %1</source>
            <translation>Согласовать припуски: первая ступень снимает %1</translation>
        </message>
        <message>
            <source>Fit the stocks in proportion, to %1 together</source>
            <translation>Согласовать припуски пропорционально, всего %1</translation>
        </message>
    </context>
    <context>
        <name>SavedFile</name>
        <message>
            <source>Saved: “%1” in %2</source>
            <translation>Сохранено: «%1» в папке %2</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>Открыть</translation>
        </message>
        <message>
            <source>Show in folder</source>
            <translation>Показать в папке</translation>
        </message>
        <message>
            <source>No program opens %1; assign one</source>
            <translation>Нет программы для %1; назначьте её</translation>
        </message>
        <message>
            <source>%1 is no longer there</source>
            <translation>%1 больше нет на месте</translation>
        </message>
    </context>
    <context>
        <name>sparkout::SearchCombo</name>
        <message>
            <source>Type to search</source>
            <translation>Введите для поиска</translation>
        </message>
        <message>
            <source>Search the list</source>
            <translation>Поиск по списку</translation>
        </message>
        <message>
            <source>Nothing found</source>
            <translation>Ничего не найдено</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StockReading</name>
        <message>
            <source>Stage stock on diameter</source>
            <translation>Припуск ступени на диаметр</translation>
        </message>
        <message>
            <source>Stock on diameter</source>
            <translation>Припуск на диаметр</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StiffnessOffer</name>
        <message>
            <source>Its effect: γ %1 nm/N; machining time %2; diameter deviations %3 µm; requirements not met %4.</source>
            <translation>Её влияние: γ %1 нм/Н; основное время %2; отклонения диаметра %3 мкм; невыполненных требований %4.</translation>
        </message>
        <message>
            <source>With it the cycle cannot be run: %1</source>
            <translation>С этой записью цикл нельзя рассчитать: %1</translation>
        </message>
        <message>
            <source>Computing its effect …</source>
            <translation>Вычисляется её влияние …</translation>
        </message>
        <message>
            <source>Effect of the stiffness</source>
            <translation>Влияние жёсткости</translation>
        </message>
        <message>
            <source>Without it the stiffness of the project stays as it is; the other values of the machine are applied.</source>
            <translation>Без отметки жёсткость в проекте остаётся прежней; остальные значения станка применяются.</translation>
        </message>
        <message>
            <source>The compliance is given on the page Machine, so a stiffness is not used there. This removes the given compliance; γ then follows from the stiffness of the machine and from the shaft.</source>
            <translation>На странице станка задана податливость, поэтому жёсткость не используется. С этой отметкой заданная податливость снимается, и γ вычисляется по жёсткости станка и по валу.</translation>
        </message>
        <message>
            <source>&amp;Compute the compliance from its stiffness</source>
            <translation>&amp;Вычислять податливость по её жёсткости</translation>
        </message>
        <message>
            <source>Use its &amp;stiffness</source>
            <translation>Применить её &amp;жёсткость</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FormPage</name>
        <message>
            <source>%1 (shared)</source>
            <translation>%1 — общее</translation>
        </message>
        <message>
            <source>All inputs (%1 more)</source>
            <translation>Все данные (ещё %1)</translation>
        </message>
        <message numerus="yes">
            <source>%1 · %n other(s) shown</source>
            <translation>
                <numerusform>%1 · показан %n другой</numerusform>
                <numerusform>%1 · показаны %n других</numerusform>
                <numerusform>%1 · показаны %n других</numerusform>
            </translation>
        </message>
        <message>
            <source>Usual inputs only</source>
            <translation>Только обычные данные</translation>
        </message>
        <message>
            <source>Besides the usual inputs, calibrated, refused and doubtful ones are shown, and those that differ from both the default and the catalogue</source>
            <translation>Кроме обычных данных показаны откалиброванные, непринятые, с предупреждением и те, что отличаются от значений по умолчанию и от каталога</translation>
        </message>
    </context>
    <context>
        <name>sparkout::SharedMark</name>
        <message>
            <source>for all surfaces</source>
            <translation>для всех поверхностей</translation>
        </message>
    </context>
    <context>
        <name>SurfaceEdits</name>
        <message>
            <source>Surface %1</source>
            <translation>Поверхность %1</translation>
        </message>
    </context>
    <context>
        <name>StatusText</name>
        <message>
            <source>not run</source>
            <translation>не рассчитано</translation>
        </message>
        <message>
            <source>inputs refused</source>
            <translation>данные не приняты</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PartStrip</name>
        <message>
            <source>%1. %2</source>
            <translation>%1. %2</translation>
        </message>
        <message>
            <source>⌀%1 × %2 mm, from %3 mm</source>
            <translation>⌀%1 × %2 мм, от %3 мм</translation>
        </message>
        <message>
            <source>Surface %1: %2, %3</source>
            <translation>Поверхность %1: %2, %3</translation>
        </message>
        <message>
            <source>%1 of %2 · %3</source>
            <translation>%1 из %2 · %3</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 из %2</translation>
        </message>
        <message>
            <source>The whole part: %1</source>
            <translation>Деталь в целом: %1</translation>
        </message>
        <message>
            <source>The part with its surfaces</source>
            <translation>Деталь с её поверхностями</translation>
        </message>
        <message>
            <source>Surfaces of the part in the order of grinding</source>
            <translation>Поверхности детали в порядке шлифования</translation>
        </message>
        <message>
            <source>Number of fit surfaces, and piece time; a click shows times and verdicts of all surfaces</source>
            <translation>Годные поверхности и штучное время; времена и заключения по всем поверхностям</translation>
        </message>
        <message>
            <source>Add, move and remove surfaces</source>
            <translation>Добавить, переставить, удалить поверхности</translation>
        </message>
        <message>
            <source>Surface %1: %2</source>
            <translation>Поверхность %1: %2</translation>
        </message>
    </context>
    <context>
        <name>SurfaceTable</name>
        <message>
            <source>not set up</source>
            <translation>не задано</translation>
        </message>
        <message>
            <source>refused</source>
            <translation>отклонено</translation>
        </message>
        <message>
            <source>none feasible</source>
            <translation>допустимых нет</translation>
        </message>
        <message>
            <source>%1 of %2 rejected</source>
            <translation>не годны %1 из %2</translation>
        </message>
        <message>
            <source>Surface</source>
            <translation>Поверхность</translation>
        </message>
        <message>
            <source>⌀, mm</source>
            <translation>⌀, мм</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>Minimum margin</source>
            <translation>Наименьший запас</translation>
        </message>
        <message>
            <source>Batch</source>
            <translation>Партия</translation>
        </message>
        <message>
            <source>Ra, estimate</source>
            <translation>Ra, оценка</translation>
        </message>
        <message>
            <source>Cycle time</source>
            <translation>Время цикла</translation>
        </message>
        <message>
            <source>%1, %2</source>
            <translation>%1, %2</translation>
        </message>
        <message>
            <source>Value / limit</source>
            <translation>Значение / предел</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Цикл</translation>
        </message>
        <message>
            <source>Found</source>
            <translation>Найдено</translation>
        </message>
    </context>
    <context>
        <name>sparkout::SurfaceBars</name>
        <message>
            <source>Surface</source>
            <translation>Поверхность</translation>
        </message>
        <message>
            <source>Cycle time</source>
            <translation>Время цикла</translation>
        </message>
        <message>
            <source>Margin</source>
            <translation>Запас</translation>
        </message>
        <message>
            <source>cycle time</source>
            <translation>время цикла</translation>
        </message>
        <message>
            <source>minimum margin</source>
            <translation>наименьший запас</translation>
        </message>
        <message>
            <source>Margin of the decided requirement nearest to its limit; below 0 if one is not met.</source>
            <translation>Запас — у ближайшего к пределу из определённых требований; ниже 0, если требование не выполнено.</translation>
        </message>
        <message>
            <source>The surfaces compared, as bars</source>
            <translation>Сравнение поверхностей столбцами</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PartWindow</name>
        <message>
            <source>The surfaces are being run…</source>
            <translation>Поверхности рассчитываются…</translation>
        </message>
        <message>
            <source>The inputs have changed since the batch and the search were run.</source>
            <translation>Исходные данные изменены после расчёта партии и поиска.</translation>
        </message>
        <message>
            <source>Stopped; partial results are shown.</source>
            <translation>Остановлено; показано сделанное до остановки.</translation>
        </message>
        <message>
            <source>Whole part</source>
            <translation>Деталь в целом</translation>
        </message>
        <message>
            <source>Surfaces of the part</source>
            <translation>Поверхности детали</translation>
        </message>
        <message>
            <source>The surfaces compared</source>
            <translation>Сравнение поверхностей</translation>
        </message>
        <message>
            <source>&amp;Optimise all</source>
            <translation>&amp;Оптимизировать все</translation>
        </message>
        <message>
            <source>Finds the quickest cycle of every surface in the order of grinding, as ticked in the view Optimise; a surface without a search gets a typical one</source>
            <translation>Ищет быстрейший цикл каждой поверхности в порядке шлифования с отмеченными в виде «Оптимизация» условиями; поверхность без поиска получает типовой</translation>
        </message>
        <message>
            <source>&amp;Batch of all</source>
            <translation>&amp;Партии всех</translation>
        </message>
        <message>
            <source>Runs the batch of every surface that has one</source>
            <translation>Рассчитывает партию каждой поверхности, у которой она есть</translation>
        </message>
        <message>
            <source>&amp;Apply the cycles found</source>
            <translation>П&amp;рименить найденные циклы</translation>
        </message>
        <message>
            <source>&amp;Stop</source>
            <translation>&amp;Остановить</translation>
        </message>
        <message>
            <source>Progress</source>
            <translation>Ход расчёта</translation>
        </message>
        <message>
            <source>%1 of %2 surfaces are fit. %3. %4: %5</source>
            <translation>Поверхностей с годным циклом: %1 из %2. %3. %4: %5</translation>
        </message>
    </context>
    <context>
        <name>sparkout::AddSurfaceDialog</name>
        <message>
            <source>Add a surface</source>
            <translation>Добавление поверхности</translation>
        </message>
        <message>
            <source>The part with its surfaces</source>
            <translation>Деталь с её поверхностями</translation>
        </message>
        <message>
            <source>Place on the part</source>
            <translation>Место на детали</translation>
        </message>
        <message>
            <source>Begins with</source>
            <translation>Начать с</translation>
        </message>
        <message>
            <source>the inputs of “%1”</source>
            <translation>данных «%1»</translation>
        </message>
        <message>
            <source>a new traverse cycle</source>
            <translation>нового цикла с продольной подачей</translation>
        </message>
        <message>
            <source>a new plunge cycle</source>
            <translation>нового врезного цикла</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Название</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>Место</translation>
        </message>
        <message>
            <source>Wheel</source>
            <translation>Круг</translation>
        </message>
        <message>
            <source>%1, %2 mm wide; it stays the wheel of all surfaces.</source>
            <translation>%1, высота %2 мм; он остаётся кругом всех поверхностей.</translation>
        </message>
        <message>
            <source>But %1.</source>
            <translation>Но %1.</translation>
        </message>
        <message>
            <source>&amp;Add</source>
            <translation>&amp;Добавить</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>Step %1: ⌀%2 × %3 mm, from %4 mm</source>
            <translation>Ступень %1: ⌀%2 × %3 мм, от %4 мм</translation>
        </message>
        <message>
            <source>%1 (free)</source>
            <translation>%1 (свободна)</translation>
        </message>
        <message>
            <source>Where “%1” is</source>
            <translation>Там же, где «%1»</translation>
        </message>
        <message>
            <source>Each surface needs its own name.</source>
            <translation>У каждой поверхности своё название.</translation>
        </message>
        <message>
            <source>Keyway and other gaps</source>
            <translation>Шпоночный и другие пазы</translation>
        </message>
        <message>
            <source>Deviations</source>
            <translation>Отклонения</translation>
        </message>
        <message>
            <source>Deviations (%1)</source>
            <translation>Отклонения (%1)</translation>
        </message>
        <message>
            <source>Tolerances of form and Ra</source>
            <translation>Допуски формы и Ra</translation>
        </message>
        <message>
            <source>From its drawing</source>
            <translation>С её чертежа</translation>
        </message>
        <message>
            <source>Duplicate the surface</source>
            <translation>Копия поверхности</translation>
        </message>
        <message>
            <source>&amp;Duplicate</source>
            <translation>&amp;Копировать</translation>
        </message>
    </context>
    <context>
        <name>sparkout::NameDialog</name>
        <message>
            <source>Name</source>
            <translation>Название</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>Action</source>
            <translation>Действие</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PartCommands</name>
        <message>
            <source>Rename the surface</source>
            <translation>Переименование поверхности</translation>
        </message>
        <message>
            <source>&amp;Rename</source>
            <translation>&amp;Переименовать</translation>
        </message>
        <message>
            <source>Each surface needs its own name.</source>
            <translation>У каждой поверхности своё название.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::TimesDialog</name>
        <message>
            <source>Standard times and wheel wear</source>
            <translation>Нормы времени и износ круга</translation>
        </message>
        <message>
            <source>&amp;Apply</source>
            <translation>&amp;Применить</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
    </context>
    <context>
        <name>PieceTimeText</name>
        <message>
            <source>T_a = %1 min, as given</source>
            <translation>T_в = %1 мин, задано</translation>
        </message>
        <message>
            <source>T_a = n·(approach + retreat + gauging) + (n − 1)·positioning + handling = %1·(%2 + %3 + %4) + %5·%6 + %7 s = %8 min</source>
            <translation>T_в = n·(подвод + отвод + измерение) + (n − 1)·перемещение + установка и снятие = %1·(%2 + %3 + %4) + %5·%6 + %7 с = %8 мин</translation>
        </message>
        <message>
            <source>T_o = %1 min, as given</source>
            <translation>T_о = %1 мин, задано</translation>
        </message>
        <message>
            <source>T_o = sum of the cycles = %1 min</source>
            <translation>T_о = сумма циклов = %1 мин</translation>
        </message>
        <message>
            <source>T_o: not known, not every cycle ends at size</source>
            <translation>T_о: неизвестно, не каждый цикл достигает размера</translation>
        </message>
        <message>
            <source>T_1 = %1 min, as given</source>
            <translation>T_шт = %1 мин, задано</translation>
        </message>
        <message>
            <source>T_1 = (T_o + T_a)·(1 + service/100) = (%1 + %2)·(1 + %3/100) = %4 min</source>
            <translation>T_шт = (T_о + T_в)·(1 + обслуживание/100) = (%1 + %2)·(1 + %3/100) = %4 мин</translation>
        </message>
        <message>
            <source>T_1 + T_p/N = %1 + %2/%3 = %4 min</source>
            <translation>T_(шт.-к) = T_шт + T_пз/N = %1 + %2/%3 = %4 мин</translation>
        </message>
        <message>
            <source>T_a is not entered, so no piece time is stated</source>
            <translation>T_в не задано, поэтому штучное время не указано</translation>
        </message>
    </context>
    <context>
        <name>Trial</name>
        <message>
            <source>size at the gauge</source>
            <translation>размер по прибору</translation>
        </message>
        <message>
            <source>power of the wheel</source>
            <translation>мощность привода круга</translation>
        </message>
        <message>
            <source>size and power</source>
            <translation>размер и мощность</translation>
        </message>
        <message>
            <source>normal force</source>
            <translation>нормальная сила</translation>
        </message>
        <message>
            <source>without spark-out</source>
            <translation>без выхаживания</translation>
        </message>
        <message>
            <source>with spark-out</source>
            <translation>с выхаживанием</translation>
        </message>
        <message>
            <source>trials, most informative first</source>
            <translation>опыты по их информативности</translation>
        </message>
        <message>
            <source>the project cannot have these parameters, or one of them is given twice</source>
            <translation>таких параметров у проекта не может быть, или один из них указан дважды</translation>
        </message>
        <message>
            <source>no trial of the project can be run</source>
            <translation>ни один опыт проекта не рассчитывается</translation>
        </message>
        <message>
            <source>stopped</source>
            <translation>остановлено</translation>
        </message>
        <message>
            <source>headstock</source>
            <translation>передняя бабка</translation>
        </message>
        <message>
            <source>tailstock</source>
            <translation>задняя бабка</translation>
        </message>
        <message>
            <source>wheel head</source>
            <translation>шлифовальная бабка</translation>
        </message>
        <message>
            <source>found</source>
            <translation>найдено</translation>
        </message>
        <message>
            <source>there are fewer places than stiffnesses to find</source>
            <translation>мест меньше, чем искомых жёсткостей</translation>
        </message>
        <message>
            <source>such a trial needs an external surface, a shaft without steady rests and places on it; of the system with a chuck or at two places the wheel head&apos;s stiffness, too</source>
            <translation>такому опыту нужны наружная поверхность, вал без люнетов и места на нём, а для системы в патроне или по двум местам — и жёсткость шлифовальной бабки</translation>
        </message>
        <message>
            <source>the readings contradict the shaft: a unit would have to be stiffer than rigid</source>
            <translation>показания противоречат валу: один из узлов должен был бы быть жёстче абсолютно жёсткого</translation>
        </message>
        <message>
            <source>deflection is in proportion to the load</source>
            <translation>прогиб пропорционален нагрузке</translation>
        </message>
        <message>
            <source>there is play, and the stiffness is that beyond it: remove the play before loading</source>
            <translation>есть зазор, и указана жёсткость после его выбора: выберите зазор перед нагружением</translation>
        </message>
        <message>
            <source>the stiffness changes with the load, and the result is a mean: load as the deepest cut does</source>
            <translation>жёсткость меняется с нагрузкой, и найденная — средняя: нагружайте так, как самый глубокий проход</translation>
        </message>
        <message>
            <source>play is undetermined: load twice, differently, at each place</source>
            <translation>есть ли зазор, определить нельзя: нагрузите в каждом месте дважды, по-разному</translation>
        </message>
    </context>
    <context>
        <name>CalibrationText</name>
        <message>
            <source>calibrated on %1 (n = %2)</source>
            <translation>откалибровано по данным: %1 (n = %2)</translation>
        </message>
        <message>
            <source>no longer the value calibrated on %1 (n = %2)</source>
            <translation>уже не то значение, что откалибровано по данным: %1 (n = %2)</translation>
        </message>
        <message>
            <source>Value found: %1</source>
            <translation>Найденное значение: %1</translation>
        </message>
        <message>
            <source>95 % interval: %1</source>
            <translation>Интервал 95 %: %1</translation>
        </message>
        <message>
            <source>Date: %1</source>
            <translation>Дата: %1</translation>
        </message>
    </context>
    <context>
        <name>CalibratedTable</name>
        <message>
            <source>Input</source>
            <translation>Исходная величина</translation>
        </message>
        <message>
            <source>Value found</source>
            <translation>Найдено</translation>
        </message>
        <message>
            <source>95 % interval</source>
            <translation>Интервал 95 %</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Ед.</translation>
        </message>
        <message>
            <source>Data</source>
            <translation>Данные</translation>
        </message>
        <message>
            <source>n</source>
            <translation>n</translation>
        </message>
        <message>
            <source>Date</source>
            <translation>Дата</translation>
        </message>
        <message>
            <source>In use</source>
            <translation>Действует</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>да</translation>
        </message>
        <message>
            <source>no, changed since</source>
            <translation>нет, изменено позже</translation>
        </message>
    </context>
    <context>
        <name>FitWords</name>
        <message>
            <source>%1, %2</source>
            <comment>parameter, zone</comment>
            <translation>%1, %2</translation>
        </message>
        <message>
            <source>current of the spindle</source>
            <translation>ток шпинделя</translation>
        </message>
        <message>
            <source>%1 (n = %2)</source>
            <translation>%1 (n = %2)</translation>
        </message>
        <message>
            <source>%1, %2 (n = %3)</source>
            <translation>%1, %2 (n = %3)</translation>
        </message>
        <message>
            <source>The data do not separate: %1. What would help: %2.</source>
            <translation>По этим данным не различаются: %1. Что поможет: %2.</translation>
        </message>
        <message>
            <source>The data determine only the product: %1. What would help: %2.</source>
            <translation>По этим данным определяется только произведение: %1. Что поможет: %2.</translation>
        </message>
        <message>
            <source>The data do not determine: %1. What would help: %2.</source>
            <translation>По этим данным не определяется: %1. Что поможет: %2.</translation>
        </message>
        <message numerus="yes">
            <source>%n measured part(s)</source>
            <translation>
                <numerusform>%n измеренная деталь</numerusform>
                <numerusform>%n измеренные детали</numerusform>
                <numerusform>%n измеренных деталей</numerusform>
            </translation>
        </message>
        <message>
            <source>Left out: %1 seems to be %2 ± %3 and was not fitted. This distorts the values found: with it fitted, %4 would be %5 instead of %6.</source>
            <translation>Не учтено: %1, по-видимому, %2 ± %3 и не определялось. Найденные значения из-за этого неверны: если определить и его, %4 составит %5 вместо %6.</translation>
        </message>
        <message>
            <source>Does not fit: %1: residuals %2 times the noise; by chance up to %3: %4.</source>
            <translation>Не подходит: %1: в %2 раза больше того, что оставляет шум; случайно — не более чем в %3: %4.</translation>
        </message>
        <message>
            <source>Does not fit: %1: %2; usual: %3.</source>
            <translation>Не подходит: %1: %2; обычно: %3.</translation>
        </message>
        <message>
            <source>%1 %2 at %3 s</source>
            <comment>a reading, its unit, its time</comment>
            <translation>%1 %2 в момент %3 с</translation>
        </message>
        <message>
            <source>Over range: %1: %2: %3.</source>
            <translation>Вне диапазона: %1: %2: %3.</translation>
        </message>
        <message>
            <source>%1 (stage %2)</source>
            <translation>%1 (ступень %2)</translation>
        </message>
        <message>
            <source>Force law: %1 (%2 revolutions; residuals %3 µm by the sources&apos; law, %4 µm with a threshold).</source>
            <translation>Закон силы: %1 (оборотов: %2; остатки %3 мкм по закону источников, %4 мкм с порогом).</translation>
        </message>
        <message>
            <source>A spark-out longer by %1 revolutions would separate them.</source>
            <translation>Их разделит выхаживание, которое длиннее на столько оборотов: %1.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::DataChoice</name>
        <message>
            <source>Measurements</source>
            <translation>Измерения</translation>
        </message>
        <message>
            <source>A current is used once its factor in kW per A is given.</source>
            <translation>Ток участвует, когда указан его коэффициент в кВт на А.</translation>
        </message>
        <message>
            <source>diameters of parts (n = %1)</source>
            <translation>диаметры деталей (n = %1)</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ParameterChoice</name>
        <message>
            <source>Parameters</source>
            <translation>Параметры</translation>
        </message>
        <message>
            <source>known before: mean ± s</source>
            <translation>известно: среднее ± s</translation>
        </message>
        <message>
            <source>A value known from elsewhere, with its standard deviation, counts as one more measurement. Factors refer to the current inputs: 1 ± 0.1 means known within about 20 %. Empty: nothing is known.</source>
            <translation>Значение, известное заранее, со стандартным отклонением участвует как ещё одно измерение. Множители относятся к текущим исходным данным: 1 ± 0,1 значит, что величина известна в пределах примерно 20 %. Пусто: ничего не известно.</translation>
        </message>
        <message>
            <source>%1: mean known before</source>
            <translation>%1: среднее, известное заранее</translation>
        </message>
        <message>
            <source>%1: its standard deviation</source>
            <translation>%1: его стандартное отклонение</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>%1: a mean known before needs its standard deviation, and vice versa.</source>
            <translation>%1: среднему, известному заранее, нужно стандартное отклонение, и наоборот.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FitResult</name>
        <message>
            <source>Values found</source>
            <translation>Найденные значения</translation>
        </message>
        <message>
            <source>Correlations of the values</source>
            <translation>Корреляции значений</translation>
        </message>
        <message>
            <source>Residuals by measurement</source>
            <translation>Остатки по измерениям</translation>
        </message>
        <message>
            <source>Residuals drawn</source>
            <translation>Остатки на графике</translation>
        </message>
        <message>
            <source>Measured minus predicted</source>
            <translation>Измерено минус расчёт</translation>
        </message>
        <message>
            <source>No fit yet. Choose measurements and parameters, then Fit.</source>
            <translation>Подбора ещё не было. Выберите измерения и параметры, затем «Подобрать».</translation>
        </message>
        <message numerus="yes">
            <source>Found from %n measured value(s).</source>
            <translation>
                <numerusform>Найдено по %n измеренному значению.</numerusform>
                <numerusform>Найдено по %n измеренным значениям.</numerusform>
                <numerusform>Найдено по %n измеренным значениям.</numerusform>
            </translation>
        </message>
        <message>
            <source>Offsets of the traces are not inputs of the project: there is nothing to apply.</source>
            <translation>Сдвиги записей не входят в исходные данные проекта: применять нечего.</translation>
        </message>
        <message>
            <source>No values: %1.</source>
            <translation>Значений нет: %1.</translation>
        </message>
        <message>
            <source>Not to be used: %1.</source>
            <translation>Использовать нельзя: %1.</translation>
        </message>
        <message>
            <source>A current without its factor in kW per A was left out.</source>
            <translation>Ток без коэффициента в кВт на А не учтён.</translation>
        </message>
        <message>
            <source>The residuals are hardly normal (probability %1): they may contain more than noise, and the intervals are too narrow.</source>
            <translation>Остатки вряд ли распределены нормально (вероятность %1): в них может оставаться не только шум, и тогда интервалы слишком узки.</translation>
        </message>
        <message>
            <source>The residuals do not contradict a normal distribution (probability %1).</source>
            <translation>Остатки не противоречат нормальному распределению (вероятность %1).</translation>
        </message>
        <message>
            <source>×</source>
            <comment>unit of a factor</comment>
            <translation>×</translation>
        </message>
        <message>
            <source>Parameter</source>
            <translation>Параметр</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>95 % interval</source>
            <translation>Интервал 95 %</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Ед.</translation>
        </message>
        <message>
            <source>Barely separable: %1 and %2.</source>
            <translation>Почти не различаются: %1 и %2.</translation>
        </message>
        <message>
            <source>Measurement</source>
            <translation>Измерение</translation>
        </message>
        <message>
            <source>RMS</source>
            <translation>СКО</translation>
        </message>
        <message>
            <source>Noise</source>
            <translation>Шум</translation>
        </message>
        <message>
            <source>Time of the trace, s</source>
            <translation>Время записи, с</translation>
        </message>
        <message>
            <source>Number of the value</source>
            <translation>Номер значения</translation>
        </message>
        <message>
            <source>Difference, %1</source>
            <translation>Разность, %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CycleFitPage</name>
        <message>
            <source>&amp;Fit</source>
            <translation>По&amp;добрать</translation>
        </message>
        <message>
            <source>&amp;Stop</source>
            <translation>&amp;Остановить</translation>
        </message>
        <message>
            <source>&amp;Leave these out</source>
            <translation>&amp;Исключить их</translation>
        </message>
        <message>
            <source>&amp;Apply</source>
            <translation>&amp;Применить</translation>
        </message>
        <message>
            <source>all values alike</source>
            <translation>все значения равноправны</translation>
        </message>
        <message>
            <source>outliers weigh less (Huber)</source>
            <translation>выбросы весят меньше (Хьюбер)</translation>
        </message>
        <message>
            <source>outliers hardly count (Tukey)</source>
            <translation>выбросы почти не в счёт (Тьюки)</translation>
        </message>
        <message>
            <source>&amp;Outliers:</source>
            <translation>&amp;Выбросы:</translation>
        </message>
        <message>
            <source>Clears undetermined parameters</source>
            <translation>Снимает отметки с неопределимых параметров</translation>
        </message>
        <message>
            <source>Applies the values found to the inputs, as one edit that can be undone, and marks them as calibrated</source>
            <translation>Заносит найденные значения в исходные данные одной правкой, которую можно отменить, и отмечает их как откалиброванные</translation>
        </message>
        <message>
            <source>Progress</source>
            <translation>Ход расчёта</translation>
        </message>
        <message>
            <source>No measurement is chosen.</source>
            <translation>Не выбрано ни одно измерение.</translation>
        </message>
        <message>
            <source>No parameter is chosen.</source>
            <translation>Не выбран ни один параметр.</translation>
        </message>
        <message>
            <source>Cycles are being run and compared …</source>
            <translation>Циклы рассчитываются и сравниваются …</translation>
        </message>
        <message>
            <source>Check that gauge, feeds and blank of the project match the recording. Fewer parameters, or values known before, also help.</source>
            <translation>Те ли в проекте прибор, подачи и заготовка, что при записи? Помогут и меньшее число параметров или то, что известно о них заранее.</translation>
        </message>
        <message>
            <source>These values cannot be applied. %1. %2</source>
            <translation>Эти значения применить нельзя. %1. %2</translation>
        </message>
        <message>
            <source>These values cannot be applied: an omitted parameter distorts them. Fit it too.</source>
            <translation>Эти значения применить нельзя: их искажает то, что не учтено. Определите и это.</translation>
        </message>
        <message>
            <source>These values cannot be applied: the model does not fit. %1</source>
            <translation>Эти значения применить нельзя: модель не подходит. %1</translation>
        </message>
        <message>
            <source>Unusual: %1. %2</source>
            <translation>Необычно: %1. %2</translation>
        </message>
        <message>
            <source>Fit &amp;this too</source>
            <translation>Определить и &amp;это</translation>
        </message>
        <message>
            <source>Checks the omitted parameters, and fits again</source>
            <translation>Отмечает то, что не учтено, и подбирает заново</translation>
        </message>
        <message>
            <source>Sizes determine only the product of compliance and dullness: with the compliance fitted in place of β, the dullness stays as it is.</source>
            <translation>Размеры определяют лишь произведение податливости и затупления: если вместо β подбирать податливость, степень затупления останется прежней.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::WheelPage</name>
        <message>
            <source>Apply the s&amp;trengths</source>
            <translation>Применить про&amp;чность</translation>
        </message>
        <message>
            <source>Roughness Ra</source>
            <translation>Шероховатость Ra</translation>
        </message>
        <message>
            <source>Apply the &amp;Ra factor</source>
            <translation>Применить &amp;поправку Ra</translation>
        </message>
        <message>
            <source>No Ra is measured, or the cycle does not end at size. Measured Ra is imported with the parts: Import measurements…</source>
            <translation>Ra не измерено, или цикл не доходит до размера. Измеренное Ra попадает в проект вместе с деталями: «Импорт измерений…»</translation>
        </message>
        <message>
            <source>Factor of Ra: %1, current %2 (n = %3).</source>
            <translation>Поправка Ra: %1, сейчас %2 (n = %3).</translation>
        </message>
        <message>
            <source>95 % interval: %1.</source>
            <translation>Интервал 95 %: %1.</translation>
        </message>
        <message>
            <source>It applies to this wheel and its dressing: %1</source>
            <translation>Она действует для этого круга и его правки: %1</translation>
        </message>
        <message>
            <source>It applies to this wheel and its dressing.</source>
            <translation>Она действует для этого круга и его правки.</translation>
        </message>
        <message numerus="yes">
            <source>measured Ra of %n part(s)</source>
            <translation>
                <numerusform>измеренное Ra %n детали</numerusform>
                <numerusform>измеренное Ra %n деталей</numerusform>
                <numerusform>измеренное Ra %n деталей</numerusform>
            </translation>
        </message>
        <message>
            <source>Strengths of the wheel</source>
            <translation>Прочность круга</translation>
        </message>
        <message>
            <source>One reading at which the wheel just began to shed its grains gives a common factor of the four strengths of grain and bond.</source>
            <translation>Одно показание, при котором круг только начал осыпаться, даёт общий множитель четырёх показателей прочности зерна и связки.</translation>
        </message>
        <message>
            <source>normal force</source>
            <translation>нормальная сила</translation>
        </message>
        <message>
            <source>power of the wheel, without idle power</source>
            <translation>мощность привода круга без холостого хода</translation>
        </message>
        <message>
            <source>Readin&amp;g:</source>
            <translation>По&amp;казание:</translation>
        </message>
        <message>
            <source>&amp;Value at the limit:</source>
            <translation>Знач&amp;ение на пределе:</translation>
        </message>
        <message>
            <source>Value at the limit</source>
            <translation>Значение на пределе</translation>
        </message>
        <message>
            <source>&amp;Width of cut:</source>
            <translation>&amp;Ширина резания:</translation>
        </message>
        <message>
            <source>Width of cut, mm</source>
            <translation>Ширина резания, мм</translation>
        </message>
        <message>
            <source>one reading at the limit, %1 %2</source>
            <translation>одно показание на пределе, %1 %2</translation>
        </message>
        <message>
            <source>Factor of the strengths: %1; depth of that cut: %2 µm.</source>
            <translation>Множитель прочности: %1; глубина того реза: %2 мкм.</translation>
        </message>
        <message>
            <source>The strengths of grain and bond are not given: the page Wheel of the inputs has them.</source>
            <translation>Прочность зерна и связки не задана: она стоит на странице «Круг» исходных данных.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CalibrationDialog</name>
        <message>
            <source>Calibrate from measurements</source>
            <translation>Калибровка по измерениям</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Цикл</translation>
        </message>
        <message>
            <source>Ra and strengths</source>
            <translation>Ra и прочность</translation>
        </message>
        <message>
            <source>&amp;Close</source>
            <translation>&amp;Закрыть</translation>
        </message>
        <message>
            <source>The project has no data to fit the cycle to: no recorded trace, no diameters of finished parts.

Import measurements… reads them from tables: the size at the gauge, the power of the wheel, the current of its spindle or the normal force over the time of one cycle, or the diameters of finished parts by zone or section.

The size alone determines α and β, that is the compliance together with the force; the power adds its two shares; with the normal force compliance, flow stress and dullness are determined separately.</source>
            <translation>Пока не к чему подбирать цикл: нет ни записей, ни диаметров готовых деталей.

Команда «Импорт измерений…» читает их из таблиц: размер по прибору активного контроля, мощность привода круга, ток его шпинделя или нормальную силу за время одного цикла либо диаметры готовых деталей по зонам или сечениям.

Один размер даёт α и β, то есть податливость вместе с силой; мощность добавляет две свои составляющие; вместе с нормальной силой различаются податливость, интенсивность напряжений и степень затупления.</translation>
        </message>
        <message>
            <source>Calibrated: %1. Undo reverts it.</source>
            <translation>Откалибровано: %1. Отменить можно командой «Отменить».</translation>
        </message>
        <message>
            <source>Stiffness trial</source>
            <translation>Опыт на жёсткость</translation>
        </message>
        <message>
            <source>Which trial</source>
            <translation>Какой опыт</translation>
        </message>
    </context>
    <context>
        <name>sparkout::TracesPlot</name>
        <message>
            <source>%1, %2</source>
            <comment>quantity, zone</comment>
            <translation>%1, %2</translation>
        </message>
        <message>
            <source>%1, %2</source>
            <comment>quantity, unit</comment>
            <translation>%1, %2</translation>
        </message>
        <message>
            <source>%1: RMS %2 %3</source>
            <comment>measured quantity</comment>
            <translation>%1: СКО %2 %3</translation>
        </message>
        <message>
            <source>Δ, %1</source>
            <translation>Δ, %1</translation>
        </message>
        <message>
            <source>measured</source>
            <translation>измерено</translation>
        </message>
        <message>
            <source>simulated</source>
            <translation>расчёт</translation>
        </message>
        <message>
            <source>measured minus simulated</source>
            <translation>измерено минус расчёт</translation>
        </message>
        <message>
            <source>difference</source>
            <translation>разность</translation>
        </message>
        <message>
            <source>measured quantity</source>
            <translation>измеренная величина</translation>
        </message>
        <message>
            <source>unit</source>
            <translation>единица</translation>
        </message>
        <message>
            <source>unit of the difference</source>
            <translation>единица разности</translation>
        </message>
        <message>
            <source>%1: nothing measured at %2 = %3</source>
            <comment>quantity, axis, place</comment>
            <translation>%1: при %2 = %3 ничего не измерено</translation>
        </message>
        <message>
            <source>%1 at %2 = %3: measured %4 %7, simulated %5 %7, difference %6 %8</source>
            <comment>quantity, axis, place, values, units</comment>
            <translation>%1 при %2 = %3: измерено %4 %7, расчёт %5 %7, разность %6 %8</translation>
        </message>
    </context>
    <context>
        <name>MeasuredBoxes</name>
        <message>
            <source>predicted</source>
            <translation>прогноз</translation>
        </message>
        <message>
            <source>measured</source>
            <translation>измерено</translation>
        </message>
        <message>
            <source>For entered statistics, the box is that of a normal law with their mean and standard deviation.</source>
            <translation>По введённой статистике: нормальный закон с её средним и отклонением.</translation>
        </message>
        <message>
            <source>tolerance band</source>
            <translation>поле допуска</translation>
        </message>
        <message>
            <source>limit</source>
            <translation>предел</translation>
        </message>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>Box: the middle half of the parts; its line and the figure at the box are the median; whiskers: the smallest and the largest part.</source>
            <translation>Прямоугольник — средняя половина деталей, черта в нём и число у него — медиана; «усы» — до наименьшей и наибольшей детали.</translation>
        </message>
        <message>
            <source>Corner parts are not a sample: their prediction has no box.</source>
            <translation>Крайние сочетания — не выборка: для их прогноза прямоугольника нет.</translation>
        </message>
        <message>
            <source>%1 of %2 comparisons are drawn.</source>
            <translation>Показано сравнений: %1 из %2.</translation>
        </message>
    </context>
    <context>
        <name>MeasuredText</name>
        <message>
            <source>whole part</source>
            <translation>вся деталь</translation>
        </message>
        <message>
            <source>%1, %2</source>
            <comment>quantity, zone</comment>
            <translation>%1, %2</translation>
        </message>
        <message>
            <source>Part number</source>
            <translation>Номер детали</translation>
        </message>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>Диаметр</translation>
        </message>
        <message>
            <source>Diameter deviation</source>
            <translation>Отклонение диаметра</translation>
        </message>
        <message>
            <source>Roundness</source>
            <translation>Отклонение от круглости</translation>
        </message>
        <message>
            <source>Radial runout</source>
            <translation>Радиальное биение</translation>
        </message>
        <message>
            <source>Cylindricity</source>
            <translation>Отклонение от цилиндричности</translation>
        </message>
        <message>
            <source>Roughness Ra</source>
            <translation>Шероховатость Ra</translation>
        </message>
        <message>
            <source>When measured</source>
            <translation>Когда измерено</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>Примечание</translation>
        </message>
        <message>
            <source>Time of the sample</source>
            <translation>Время отсчёта</translation>
        </message>
        <message>
            <source>Size at the gauge</source>
            <translation>Размер по прибору</translation>
        </message>
        <message>
            <source>Wheel power</source>
            <translation>Мощность привода круга</translation>
        </message>
        <message>
            <source>Spindle current</source>
            <translation>Ток шпинделя</translation>
        </message>
        <message>
            <source>Normal force</source>
            <translation>Нормальная сила</translation>
        </message>
        <message>
            <source>Not read</source>
            <translation>Не читается</translation>
        </message>
        <message>
            <source>ms</source>
            <translation>мс</translation>
        </message>
        <message>
            <source>W</source>
            <translation>Вт</translation>
        </message>
        <message>
            <source>kN</source>
            <translation>кН</translation>
        </message>
        <message>
            <source>A</source>
            <translation>А</translation>
        </message>
        <message>
            <source>unknown</source>
            <translation>неизвестна</translation>
        </message>
        <message>
            <source>Line %1: %2</source>
            <translation>Строка %1: %2</translation>
        </message>
        <message>
            <source>Line %1, column %2: %3</source>
            <translation>Строка %1, столбец %2: %3</translation>
        </message>
        <message>
            <source>%1 of %2 (%3…%4)</source>
            <comment>parts inside, all parts, interval</comment>
            <translation>%1 из %2 (%3…%4)</translation>
        </message>
        <message>
            <source>The compliance, the force or the setting of the gauge are not those of the machine: calibrate them on these parts before the prediction is used.</source>
            <translation>Податливость, сила или настройка прибора не те, что у станка: откалибруйте их по этим деталям, прежде чем пользоваться прогнозом.</translation>
        </message>
        <message>
            <source>The factors of the batch do not scatter as in the shop: enter the measured scatter of stock, runout and dullness in the batch.</source>
            <translation>Факторы партии рассеиваются иначе, чем в цехе: задайте в партии измеренное рассеяние припуска, биения и затупления.</translation>
        </message>
        <message>
            <source>Calibrate compliance, force or the setting of the gauge first, then compare the scatter again.</source>
            <translation>Сначала откалибруйте податливость, силу или настройку прибора, затем сравните рассеяние снова.</translation>
        </message>
        <message>
            <source>Measure more parts of the same setting.</source>
            <translation>Измерьте больше деталей той же наладки.</translation>
        </message>
        <message>
            <source>These measurements do not test the model.</source>
            <translation>Эти измерения не проверяют модель.</translation>
        </message>
        <message numerus="yes">
            <source>and %n more</source>
            <translation>
                <numerusform>и ещё %n</numerusform>
                <numerusform>и ещё %n</numerusform>
                <numerusform>и ещё %n</numerusform>
            </translation>
        </message>
        <message>
            <source>%1: %2.</source>
            <comment>verdict, of what</comment>
            <translation>%1: %2.</translation>
        </message>
        <message>
            <source>%1: %2. %3</source>
            <comment>verdict, of what, what follows</comment>
            <translation>%1: %2. %3</translation>
        </message>
        <message>
            <source>Diameter</source>
            <comment>brief</comment>
            <translation>Диаметр</translation>
        </message>
        <message>
            <source>Runout</source>
            <comment>brief</comment>
            <translation>Биение</translation>
        </message>
        <message>
            <source>Roundness</source>
            <comment>brief</comment>
            <translation>Откл. от круглости</translation>
        </message>
        <message>
            <source>Cylindricity</source>
            <comment>brief</comment>
            <translation>Откл. от цилиндр.</translation>
        </message>
        <message>
            <source>agrees</source>
            <translation>согласуется</translation>
        </message>
        <message>
            <source>biased</source>
            <translation>смещение</translation>
        </message>
        <message>
            <source>scatter differs</source>
            <translation>иное рассеяние</translation>
        </message>
        <message>
            <source>biased, scatter differs</source>
            <translation>смещение, рассеяние</translation>
        </message>
        <message>
            <source>too few parts</source>
            <translation>мало деталей</translation>
        </message>
        <message>
            <source>not predicted</source>
            <translation>нет прогноза</translation>
        </message>
        <message>
            <source>%1 %2</source>
            <comment>quantity, zones</comment>
            <translation>%1 %2</translation>
        </message>
        <message>
            <source>Ra is brought into line by its factor: Calibrate from measurements…, page “Ra and strengths”.</source>
            <translation>Ra приводит в соответствие его поправка: «Калибровка по измерениям…», страница «Ra и прочность».</translation>
        </message>
        <message>
            <source>A bias of runout or roundness is the form of the machine, of its centres and its headstock, and not its compliance.</source>
            <translation>Смещение биения или отклонения от круглости — это форма станка, его центров и передней бабки, а не его податливость.</translation>
        </message>
        <message>
            <source>Not used for the calibration, %1: %2: %3 %4, predicted %5 (%6). The prediction agrees.</source>
            <translation>Не использовано при калибровке, %1: %2: %3 %4, прогноз %5 (%6). Прогноз согласуется.</translation>
        </message>
        <message>
            <source>Not used for the calibration, %1: %2: %3 %4, predicted %5 (%6). The prediction does not agree: the difference is %7 %4.</source>
            <translation>Не использовано при калибровке, %1: %2: %3 %4, прогноз %5 (%6). Прогноз не согласуется: разность %7 %4.</translation>
        </message>
    </context>
    <context>
        <name>MeasuredView</name>
        <message>
            <source>%1 of %2 parts predicted</source>
            <translation>Спрогнозировано деталей: %1 из %2</translation>
        </message>
    </context>
    <context>
        <name>PassportMeasured</name>
        <message numerus="yes">
            <source>Mean with Student&apos;s interval of 95 %; predicted: the range that contains 95 % of %n part(s) of the batch; F: the ratio of the variance of the measured parts to the predicted one, with the limits that it stays within by chance; inside: measured parts within the predicted range.</source>
            <translation>
                <numerusform>Среднее с 95 %-ным интервалом Стьюдента; прогноз: диапазон, в котором лежат 95 % из %n детали партии; F: дисперсия измеренных деталей к прогнозной и границы, в которых отношение бывает случайно; внутри: измеренные детали в прогнозном диапазоне.</numerusform>
                <numerusform>Среднее с 95 %-ным интервалом Стьюдента; прогноз: диапазон, в котором лежат 95 % из %n деталей партии; F: дисперсия измеренных деталей к прогнозной и границы, в которых отношение бывает случайно; внутри: измеренные детали в прогнозном диапазоне.</numerusform>
                <numerusform>Среднее с 95 %-ным интервалом Стьюдента; прогноз: диапазон, в котором лежат 95 % из %n деталей партии; F: дисперсия измеренных деталей к прогнозной и границы, в которых отношение бывает случайно; внутри: измеренные детали в прогнозном диапазоне.</numerusform>
            </translation>
        </message>
        <message>
            <source>The range in parentheses is that of the calibrated inputs at the ends of their 95 % intervals.</source>
            <translation>В скобках – диапазон при откалиброванных данных на границах их 95 %-ных интервалов.</translation>
        </message>
    </context>
    <context>
        <name>AdequacyTable</name>
        <message>
            <source>Quantity</source>
            <translation>Показатель</translation>
        </message>
        <message>
            <source>n</source>
            <translation>n</translation>
        </message>
        <message>
            <source>Mean ± 95 %, µm</source>
            <translation>Среднее ± 95 %, мкм</translation>
        </message>
        <message>
            <source>Predicted, µm</source>
            <translation>Прогноз, мкм</translation>
        </message>
        <message>
            <source>F</source>
            <translation>F</translation>
        </message>
        <message>
            <source>Inside</source>
            <translation>Внутри</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>Where</source>
            <translation>Где</translation>
        </message>
        <message>
            <source>Bias (limit), µm</source>
            <translation>Смещение (предел), мкм</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ColumnsModel</name>
        <message>
            <source>Heading</source>
            <translation>Заголовок</translation>
        </message>
        <message>
            <source>Column contents</source>
            <translation>Что в столбце</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Zone or section</source>
            <translation>Зона или сечение</translation>
        </message>
        <message>
            <source>as stated in the table</source>
            <translation>как в таблице</translation>
        </message>
        <message>
            <source>%1 of the column “%2”</source>
            <translation>%1, столбец «%2»</translation>
        </message>
        <message>
            <source>Column %1</source>
            <translation>Столбец %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::DataModel</name>
        <message>
            <source>Row %1, %2: %3</source>
            <translation>Строка %1, %2: %3</translation>
        </message>
        <message>
            <source>Samples</source>
            <translation>Отсчёты</translation>
        </message>
        <message>
            <source>“%1” is not one of the choices</source>
            <translation>«%1» нет среди вариантов</translation>
        </message>
        <message>
            <source>“%1” is not a number from %2; separate several by semicolons</source>
            <translation>«%1» — не число из диапазона %2; разделяйте точкой с запятой</translation>
        </message>
    </context>
    <context>
        <name>sparkout::DataSheet</name>
        <message>
            <source>Measured parts</source>
            <translation>Измеренные детали</translation>
        </message>
        <message>
            <source>A row for each zone or section of a part. Double click or F2 edits a cell; separate several diameters by semicolons.</source>
            <translation>Строка на каждую зону или сечение детали. Двойной щелчок или F2 правит ячейку; диаметры разделяйте точкой с запятой.</translation>
        </message>
        <message>
            <source>Measured statistics</source>
            <translation>Статистика измерений</translation>
        </message>
        <message>
            <source>Statistics of parts that are not listed one by one, as in a printed table: the mean with the value after ±, and the number of parts.</source>
            <translation>Статистика деталей, не перечисленных поштучно, как в печатной таблице: среднее, то, что стоит за знаком ±, и число деталей.</translation>
        </message>
        <message>
            <source>Measured traces</source>
            <translation>Записи по времени</translation>
        </message>
        <message>
            <source>Quantities over the time of one cycle, as they were imported. Place, power to current, idle value and note can be edited.</source>
            <translation>Величины по времени одного цикла, как они импортированы. Правятся место, мощность на ток, значение холостого хода и примечание.</translation>
        </message>
        <message>
            <source>Add a row</source>
            <translation>Добавить строку</translation>
        </message>
        <message>
            <source>Add a row at the end</source>
            <translation>Добавить строку в конец</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Удалить</translation>
        </message>
        <message>
            <source>Remove the rows of the selected cells (Ctrl+Del)</source>
            <translation>Удалить строки выделенных ячеек (Ctrl+Del)</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ImportDialog</name>
        <message>
            <source>&amp;Leave out the refused cells and import the rest</source>
            <translation>&amp;Пропустить непринятые ячейки и импортировать остальное</translation>
        </message>
        <message>
            <source>&amp;Add to the measurements</source>
            <translation>&amp;Добавить к измеренному</translation>
        </message>
        <message>
            <source>&amp;Replace the measurements</source>
            <translation>&amp;Заменить измеренное</translation>
        </message>
        <message>
            <source>Import measurements: pasted table</source>
            <translation>Импорт измерений: вставленная таблица</translation>
        </message>
        <message>
            <source>Import measurements: %1</source>
            <translation>Импорт измерений: %1</translation>
        </message>
        <message>
            <source>Headings above columns</source>
            <translation>Столбцы с заголовками</translation>
        </message>
        <message>
            <source>Lines time|key|value</source>
            <translation>Строки время|ключ|значение</translation>
        </message>
        <message>
            <source>comma</source>
            <translation>запятая</translation>
        </message>
        <message>
            <source>semicolon</source>
            <translation>точка с запятой</translation>
        </message>
        <message>
            <source>tab</source>
            <translation>табуляция</translation>
        </message>
        <message>
            <source>vertical bar</source>
            <translation>вертикальная черта</translation>
        </message>
        <message>
            <source>point</source>
            <translation>точка</translation>
        </message>
        <message>
            <source>from 0</source>
            <translation>с 0</translation>
        </message>
        <message>
            <source>from 1</source>
            <translation>с 1</translation>
        </message>
        <message>
            <source>La&amp;yout:</source>
            <translation>&amp;Вид:</translation>
        </message>
        <message>
            <source>&amp;Delimiter:</source>
            <translation>&amp;Разделитель:</translation>
        </message>
        <message>
            <source>Deci&amp;mal mark:</source>
            <translation>Д&amp;есятичный знак:</translation>
        </message>
        <message>
            <source>&amp;Zones are counted:</source>
            <translation>&amp;Счёт зон:</translation>
        </message>
        <message>
            <source>&amp;Power to current, kW/A:</source>
            <translation>М&amp;ощность на ток, кВт/А:</translation>
        </message>
        <message>
            <source>Columns of the table</source>
            <translation>Столбцы таблицы</translation>
        </message>
        <message>
            <source>First lines of the table</source>
            <translation>Первые строки таблицы</translation>
        </message>
        <message>
            <source>Reading</source>
            <translation>Чтение</translation>
        </message>
        <message>
            <source>Refused cells</source>
            <translation>Непринятые ячейки</translation>
        </message>
        <message>
            <source>&amp;Import</source>
            <translation>&amp;Импортировать</translation>
        </message>
        <message>
            <source>C&amp;ancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>… and more</source>
            <translation>… и другие</translation>
        </message>
        <message numerus="yes">
            <source>%n part(s)</source>
            <translation>
                <numerusform>%n деталь</numerusform>
                <numerusform>%n детали</numerusform>
                <numerusform>%n деталей</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n row(s) of zones or sections that the project does not have</source>
            <translation>
                <numerusform>%n строка о зонах или сечениях, которых нет в проекте</numerusform>
                <numerusform>%n строки о зонах или сечениях, которых нет в проекте</numerusform>
                <numerusform>%n строк о зонах или сечениях, которых нет в проекте</numerusform>
            </translation>
        </message>
        <message>
            <source>%1: %2 of %3 samples, as means</source>
            <translation>%1: %2 из %3 отсчётов, средние</translation>
        </message>
        <message>
            <source>%1: %2 samples</source>
            <translation>%1: %2 отсчётов</translation>
        </message>
        <message numerus="yes">
            <source>%n line(s) read</source>
            <translation>
                <numerusform>Прочитана %n строка</numerusform>
                <numerusform>Прочитано %n строки</numerusform>
                <numerusform>Прочитано %n строк</numerusform>
            </translation>
        </message>
        <message>
            <source>%1: %2.</source>
            <comment>lines, what is found in them</comment>
            <translation>%1: %2.</translation>
        </message>
        <message>
            <source>There is nothing to import.</source>
            <translation>Импортировать нечего.</translation>
        </message>
        <message>
            <source>A project holds at most %1 rows of parts; with these it would be %2.</source>
            <translation>В проекте не больше %1 строк деталей; с этими их было бы %2.</translation>
        </message>
        <message>
            <source>A project holds at most %1 traces; with these it would be %2.</source>
            <translation>В проекте не больше %1 записей; с этими их было бы %2.</translation>
        </message>
        <message>
            <source>Reading all lines. A change or Cancel stops it.</source>
            <translation>Читаются все строки. Любое изменение или «Отмена» прерывает чтение.</translation>
        </message>
        <message numerus="yes">
            <source>%n cell(s) are refused:</source>
            <translation>
                <numerusform>Не принята %n ячейка:</numerusform>
                <numerusform>Не приняты %n ячейки:</numerusform>
                <numerusform>Не принято %n ячеек:</numerusform>
            </translation>
        </message>
        <message>
            <source>Reading stopped early because too many cells are refused. Check the delimiter, the decimal mark and the columns.</source>
            <translation>Не принято столько ячеек, что строки не прочитаны до конца. Верны ли разделитель, десятичный знак и столбцы?</translation>
        </message>
        <message>
        <source>no column names a zone or section: all values are taken as those of %1</source>
        <translation>ни один столбец не называет зону или сечение: все значения приняты для %1</translation>
    </message>
</context>
    <context>
        <name>sparkout::MeasuredImport</name>
        <message>
            <source>Import measurements</source>
            <translation>Импорт измерений</translation>
        </message>
        <message>
            <source>Tables (*.csv *.txt *.tsv *.dat);;All files (*)</source>
            <translation>Таблицы (*.csv *.txt *.tsv *.dat);;Все файлы (*)</translation>
        </message>
        <message>
            <source>Reading %1</source>
            <translation>Чтение: %1</translation>
        </message>
        <message>
            <source>The file was not read</source>
            <translation>Файл не прочитан</translation>
        </message>
        <message>
            <source>Nothing to paste</source>
            <translation>Вставлять нечего</translation>
        </message>
        <message>
            <source>The clipboard holds no table. Copy the cells of a spreadsheet with their headings first.</source>
            <translation>В буфере обмена нет таблицы. Сначала скопируйте ячейки электронной таблицы вместе с заголовками.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::MeasuredView</name>
        <message numerus="yes">
            <source>The prediction is of a batch of %n part(s).</source>
            <translation>
                <numerusform>Прогноз получен по партии из %n детали.</numerusform>
                <numerusform>Прогноз получен по партии из %n деталей.</numerusform>
                <numerusform>Прогноз получен по партии из %n деталей.</numerusform>
            </translation>
        </message>
        <message>
            <source>No contradiction with the model; %1 of %2 comparisons agree.</source>
            <translation>Противоречий с моделью нет; согласуется сравнений: %1 из %2.</translation>
        </message>
        <message>
            <source>The model does not agree with the parts; %1 of %2 comparisons agree.</source>
            <translation>Модель не согласуется с деталями; согласуется сравнений: %1 из %2.</translation>
        </message>
        <message>
            <source>Measured</source>
            <translation>Измерения</translation>
        </message>
        <message>
            <source>Point at a box to read its values.</source>
            <translation>Значения — под указателем.</translation>
        </message>
        <message>
            <source>The inputs are refused; the prediction is that of the last valid inputs.</source>
            <translation>Исходные данные не приняты; прогноз — по последним верным.</translation>
        </message>
        <message>
            <source>No part is measured yet. Measured diameters, runout, roundness, cylindricity and roughness will be shown here beside the predicted batch, with a verdict on the model. Import a table of a measuring machine, paste one from a spreadsheet (Ctrl+V), or enter the statistics of a printed table under “Statistics”.</source>
            <translation>Измеренных деталей ещё нет. Здесь измеренные диаметры, биение, отклонения от круглости и цилиндричности и шероховатость встанут рядом с прогнозом партии, с заключением о модели. Импортируйте таблицу измерительной машины, вставьте её из электронной таблицы (Ctrl+V) или введите статистику печатной таблицы в разделе «Статистика».</translation>
        </message>
        <message>
            <source>The predicted batch cannot be run:</source>
            <translation>Партию для прогноза рассчитать нельзя:</translation>
        </message>
        <message>
            <source>The predicted batch takes a while: press “Run”. It can be stopped at any time.</source>
            <translation>Расчёт партии для прогноза займёт время: нажмите «Рассчитать». Его можно остановить в любой момент.</translation>
        </message>
        <message>
            <source>This project describes no batch, so the prediction is one part without scatter. Choose the scattering factors on the page Batch of the inputs.</source>
            <translation>Партия в проекте не описана, поэтому прогноз — одна деталь без рассеяния. Выберите на странице «Партия», что рассеивается.</translation>
        </message>
        <message>
            <source>Legend of the comparison</source>
            <translation>Легенда сравнения</translation>
        </message>
        <message>
            <source>State of the comparison</source>
            <translation>Состояние сравнения</translation>
        </message>
        <message>
            <source>Values under the mouse</source>
            <translation>Значения под указателем</translation>
        </message>
        <message>
            <source>Measured parts beside the predicted ones</source>
            <translation>Измеренные детали рядом с прогнозом</translation>
        </message>
        <message>
            <source>Extent of the comparison</source>
            <translation>Что сравнивалось</translation>
        </message>
        <message>
            <source>Progress of the batch</source>
            <translation>Ход расчёта партии</translation>
        </message>
        <message>
            <source>Measured against predicted</source>
            <translation>Измерения и прогноз</translation>
        </message>
        <message>
            <source>Verdict on the model</source>
            <translation>Заключение о модели</translation>
        </message>
        <message>
            <source>Comparison</source>
            <translation>Сравнение</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>Детали</translation>
        </message>
        <message>
            <source>Statistics</source>
            <translation>Статистика</translation>
        </message>
        <message>
            <source>Traces</source>
            <translation>Записи</translation>
        </message>
        <message>
            <source>Displayed results of the measurements</source>
            <translation>Что показано из измерений</translation>
        </message>
        <message>
            <source>Measured quantity</source>
            <translation>Измеренная величина</translation>
        </message>
        <message>
            <source>Run</source>
            <translation>Рассчитать</translation>
        </message>
        <message>
            <source>Run the predicted batch; a quick one runs by itself</source>
            <translation>Рассчитать партию для прогноза; быстрая рассчитывается сама</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Остановить</translation>
        </message>
        <message>
            <source>Stop the batch; the completed parts are kept and shown</source>
            <translation>Остановить расчёт партии; сделанное сохраняется и показывается</translation>
        </message>
        <message>
            <source>Import…</source>
            <translation>Импорт…</translation>
        </message>
        <message>
            <source>Read a table of measured parts or of traces from a file</source>
            <translation>Прочитать таблицу измеренных деталей или записей из файла</translation>
        </message>
        <message>
            <source>Paste…</source>
            <translation>Вставить…</translation>
        </message>
        <message>
            <source>Read a table that was copied from a spreadsheet (Ctrl+V)</source>
            <translation>Прочитать таблицу, скопированную из электронной таблицы (Ctrl+V)</translation>
        </message>
        <message>
            <source>Import measurements…</source>
            <translation>Импорт измерений…</translation>
        </message>
        <message>
            <source>Recorded over time: %1. The view Feeds draws it over the simulated curves, “Calibrate…” fits the process to it, the list “Traces” keeps it. No part is measured yet that could be compared with the predicted batch.</source>
            <translation>Записано по времени: %1. Вид «Подачи» рисует это поверх расчётных кривых, «Калибровка…» подбирает по этому процесс, в списке «Записи» оно хранится. Измеренных деталей, которые можно сравнить с партией, ещё нет.</translation>
        </message>
        <message>
            <source>Calibrate…</source>
            <translation>Калибровка…</translation>
        </message>
        <message>
            <source>Fit compliance, force and wheel to the measurements</source>
            <translation>Подобрать податливость, силу и круг по измеренному</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StiffnessModel</name>
        <message>
            <source>“%1” is not a number.</source>
            <translation>«%1» — не число.</translation>
        </message>
        <message>
            <source>The place is missing.</source>
            <translation>Не указано место.</translation>
        </message>
        <message>
            <source>The load must be above 0 N.</source>
            <translation>Нагрузка должна быть больше 0 Н.</translation>
        </message>
        <message>
            <source>Row %1: %2</source>
            <translation>Строка %1: %2</translation>
        </message>
        <message>
            <source>%1, row %2</source>
            <translation>%1, строка %2</translation>
        </message>
        <message>
            <source>Place, mm</source>
            <translation>Место, мм</translation>
        </message>
        <message>
            <source>Load, N</source>
            <translation>Нагрузка, Н</translation>
        </message>
        <message>
            <source>Deflection, µm</source>
            <translation>Отжатие, мкм</translation>
        </message>
    </context>
    <context>
        <name>StiffnessSheet</name>
        <message>
            <source>Clamp the part between the centres as for grinding. Wheel and drives are at rest, the wheel does not touch the part.</source>
            <translation>Установите деталь в центрах, как для шлифования. Круг и приводы неподвижны, круг детали не касается.</translation>
        </message>
        <message>
            <source>Clamp the part in the chuck as for grinding. Wheel and drives are at rest, the wheel does not touch the part.</source>
            <translation>Закрепите деталь в патроне, как для шлифования. Круг и приводы неподвижны, круг детали не касается.</translation>
        </message>
        <message>
            <source>Set an indicator that reads 1 µm or finer on the bed, against the part, opposite to the wheel, at the first place: %1 mm from the headstock&apos;s end of the shaft.</source>
            <translation>Установите на станину индикатор с ценой деления не грубее 1 мкм, против круга, наконечником на деталь в первом месте: %1 мм от конца вала у передней бабки.</translation>
        </message>
        <message>
            <source>Load the part there radially, from the side of the wheel, by a dynamometer: once to %1 N and back, to take the play out. Zero the indicator without load.</source>
            <translation>Нагрузите деталь в этом месте радиально, со стороны круга, через динамометр: один раз до %1 Н и обратно, чтобы выбрать зазоры. Без нагрузки установите индикатор на нуль.</translation>
        </message>
        <message>
            <source>Read the deflection at %1 N and at %2 N. Unload; the indicator must come back to zero. Read both once more.</source>
            <translation>Снимите отжатие при %1 Н и при %2 Н. Разгрузите; индикатор должен вернуться к нулю. Снимите оба отсчёта ещё раз.</translation>
        </message>
        <message>
            <source>Repeat this at the other places: %1 mm.</source>
            <translation>Сделайте то же в других местах: %1 мм.</translation>
        </message>
        <message>
            <source> and </source>
            <translation> и </translation>
        </message>
        <message>
            <source>To include the wheel head, set the indicator on the wheel head instead of the bed, apply the load between wheel head and part, and choose this below.</source>
            <translation>Чтобы найти и шлифовальную бабку, установите индикатор на неё вместо станины, нагружайте между шлифовальной бабкой и деталью и укажите это у показаний.</translation>
        </message>
        <message>
            <source>Enter the deflections. Two places determine headstock and tailstock; the third shows whether the readings agree.</source>
            <translation>Введите отжатия. Два места дают переднюю и заднюю бабки, третье показывает, согласны ли показания.</translation>
        </message>
        <message>
            <source>Project:</source>
            <translation>Проект:</translation>
        </message>
        <message>
            <source>Part:</source>
            <translation>Деталь:</translation>
        </message>
        <message>
            <source>Machine:</source>
            <translation>Станок:</translation>
        </message>
        <message>
            <source>Date, name:</source>
            <translation>Дата, фамилия:</translation>
        </message>
        <message>
            <source>Place, mm</source>
            <translation>Место, мм</translation>
        </message>
        <message>
            <source>Load, N</source>
            <translation>Нагрузка, Н</translation>
        </message>
        <message>
            <source>Deflection, µm</source>
            <translation>Отжатие, мкм</translation>
        </message>
        <message>
            <source>Once more, µm</source>
            <translation>Повторно, мкм</translation>
        </message>
        <message>
            <source>Stiffness trial</source>
            <translation>Опыт на жёсткость</translation>
        </message>
        <message>
            <source>Print the sheet</source>
            <translation>Печать листа</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StiffnessPage</name>
        <message>
            <source>Stiffness found</source>
            <translation>Найденная жёсткость</translation>
        </message>
        <message>
            <source>Compliance along the part</source>
            <translation>Податливость вдоль детали</translation>
        </message>
        <message>
            <source>&amp;Apply the stiffness</source>
            <translation>&amp;Применить жёсткости</translation>
        </message>
        <message>
            <source>&amp;Print the sheet…</source>
            <translation>Пе&amp;чать листа…</translation>
        </message>
        <message>
            <source>These steps and a table to write the readings into, on one page</source>
            <translation>Эти шаги и таблица для записи показаний на одной странице</translation>
        </message>
        <message>
            <source>on the bed</source>
            <translation>на станине</translation>
        </message>
        <message>
            <source>on the wheel head</source>
            <translation>на шлифовальной бабке</translation>
        </message>
        <message>
            <source>&amp;Indicator:</source>
            <translation>&amp;Индикатор:</translation>
        </message>
        <message>
            <source>Readings of the trial</source>
            <translation>Показания опыта</translation>
        </message>
        <message>
            <source>Type the deflections, or paste a table of place, load and deflection with Ctrl+V</source>
            <translation>Введите отжатия или вставьте таблицу из места, нагрузки и отжатия: Ctrl+V</translation>
        </message>
        <message>
            <source>Applies the stiffness found to the machine, as one edit that can be undone, and marks it as calibrated; γ then follows from it</source>
            <translation>Даёт станку найденные жёсткости одной правкой, которую можно отменить, отмечает их как откалиброванные, и γ вычисляется по ним</translation>
        </message>
        <message>
            <source>Inputs of the project are missing or wrong: first correct the faults in the messages.</source>
            <translation>В проекте не хватает исходных данных или они неверны: сначала исправьте то, что названо в сообщениях.</translation>
        </message>
        <message>
            <source>Enter the deflections: the result is shown here at once.</source>
            <translation>Введите отжатия: результат сразу появится здесь.</translation>
        </message>
        <message>
            <source>Nothing can be found: %1.</source>
            <translation>Найти ничего нельзя: %1.</translation>
        </message>
        <message>
            <source>Nothing can be found: %1 (%2).</source>
            <translation>Найти ничего нельзя: %1 (%2).</translation>
        </message>
        <message>
            <source>not measured</source>
            <translation>не измерено</translation>
        </message>
        <message>
            <source>Stiffness, N/µm</source>
            <translation>Жёсткость, Н/мкм</translation>
        </message>
        <message>
            <source>now</source>
            <translation>сейчас</translation>
        </message>
        <message>
            <source>found</source>
            <translation>найдено</translation>
        </message>
        <message>
            <source>The wheel head&apos;s stiffness is not known: %1 N/µm is put in, to be measured with the indicator on the wheel head.</source>
            <translation>Жёсткость шлифовальной бабки неизвестна: подставлено %1 Н/мкм; измерьте её, установив индикатор на шлифовальную бабку.</translation>
        </message>
        <message>
            <source>The given compliance is removed; γ then follows from stiffness and shaft.</source>
            <translation>Заданная податливость убирается; γ тогда вычисляется по жёсткости и валу.</translation>
        </message>
        <message>
            <source>then</source>
            <translation>станет</translation>
        </message>
        <message numerus="yes">
            <source>stiffness trial at %n place(s)</source>
            <translation>
                <numerusform>опыт на жёсткость в %n месте</numerusform>
                <numerusform>опыт на жёсткость в %n местах</numerusform>
                <numerusform>опыт на жёсткость в %n местах</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n reading(s); those less what the stiffness gives: RMS %1 µm.</source>
            <translation>
                <numerusform>%n показание; отклонения от найденной жёсткости: СКО %1 мкм.</numerusform>
                <numerusform>%n показания; отклонения от найденной жёсткости: СКО %1 мкм.</numerusform>
                <numerusform>%n показаний; отклонения от найденной жёсткости: СКО %1 мкм.</numerusform>
            </translation>
        </message>
        <message>
            <source>γ, mm/N</source>
            <translation>γ, мм/Н</translation>
        </message>
        <message>
            <source>x, mm</source>
            <translation>x, мм</translation>
        </message>
        <message>
            <source>95 %</source>
            <translation>95 %</translation>
        </message>
        <message>
            <source>The trial needs an external surface and a shaft without steady rests, whose steps are given on the page Part of the inputs: its bending is computed and subtracted from the readings.</source>
            <translation>Опыт — для наружной поверхности и вала без люнетов, ступени которого заданы на странице «Деталь» исходных данных: его изгиб вычисляется и вычитается из показаний.</translation>
        </message>
        <message>
            <source>Attention: %1.</source>
            <translation>Внимание: %1.</translation>
        </message>
        <message>
            <source>Attention: %1 (%2 µm).</source>
            <comment>what is wrong, play of the units</comment>
            <translation>Внимание: %1 (%2 мкм).</translation>
        </message>
    </context>
    <context>
        <name>sparkout::TrialPage</name>
        <message>
            <source>Trials, most informative first</source>
            <translation>Опыты по их информативности</translation>
        </message>
        <message>
            <source>&amp;Compare trials</source>
            <translation>&amp;Сравнить опыты</translation>
        </message>
        <message>
            <source>&amp;Stop</source>
            <translation>&amp;Остановить</translation>
        </message>
        <message>
            <source>Purpose of the trial</source>
            <translation>Что узнать в опыте</translation>
        </message>
        <message>
            <source>anything</source>
            <translation>что угодно</translation>
        </message>
        <message>
            <source>&amp;Can be recorded:</source>
            <translation>Можно &amp;записать:</translation>
        </message>
        <message>
            <source>Progress</source>
            <translation>Ход расчёта</translation>
        </message>
        <message>
            <source>Inputs of the project are missing or wrong: first correct the faults in the messages.</source>
            <translation>В проекте не хватает исходных данных или они неверны: сначала исправьте то, что названо в сообщениях.</translation>
        </message>
        <message>
            <source>No parameter is chosen.</source>
            <translation>Не выбран ни один параметр.</translation>
        </message>
        <message>
            <source>Trials are being run …</source>
            <translation>Опыты рассчитываются…</translation>
        </message>
        <message>
            <source>undetermined</source>
            <translation>не определяется</translation>
        </message>
        <message>
            <source>Before the machine grinds a trial, this compares 24 of them: a third, one and three times the feed of the first stage, without and with a spark-out, by the recorded quantities. The best one narrows the chosen parameters down most.</source>
            <translation>Прежде чем шлифовать опытную деталь, здесь сравниваются 24 опыта: подача первой ступени, втрое меньше и втрое больше, без выхаживания и с ним, по тому, что записывается. Лучший опыт точнее всех определяет выбранные параметры.</translation>
        </message>
        <message>
            <source>No trials: %1.</source>
            <translation>Опытов нет: %1.</translation>
        </message>
        <message>
            <source>Recorded</source>
            <translation>Запись</translation>
        </message>
        <message>
            <source>without spark-out</source>
            <translation>без выхаживания</translation>
        </message>
        <message>
            <source>All the stock at %1 %2, %3, about %4 s; record: %5.</source>
            <translation>Весь припуск на подаче %1 %2, %3, около %4 с; записать: %5.</translation>
        </message>
        <message>
            <source>None of the trials records this.</source>
            <translation>Ни один из опытов этого не записывает.</translation>
        </message>
        <message>
            <source>Most informative trial:</source>
            <translation>Самый информативный опыт:</translation>
        </message>
        <message>
            <source>The chosen trial:</source>
            <translation>Выбранный опыт:</translation>
        </message>
        <message>
            <source>Undetermined: %1.</source>
            <translation>Он не определяет: %1.</translation>
        </message>
        <message>
            <source>The intervals are those expected at 95 % about the current inputs, for %1 values a second with a scatter of %2 µm, %3 kW or %4 % of the maximum force. Then import the trace and calibrate on the page Cycle.</source>
            <translation>Интервалы — ожидаемые 95 %-е около текущих исходных данных, при %1 отсчётах в секунду с разбросом %2 мкм, %3 кВт или %4 % наибольшей силы. Затем импортируйте запись и калибруйте на странице «Цикл».</translation>
        </message>
        <message numerus="yes">
            <source>then %n double stroke(s) of spark-out</source>
            <translation>
                <numerusform>затем %n двойной ход выхаживания</numerusform>
                <numerusform>затем %n двойных хода выхаживания</numerusform>
                <numerusform>затем %n двойных ходов выхаживания</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>then %n revolution(s) of spark-out</source>
            <translation>
                <numerusform>затем %n оборот выхаживания</numerusform>
                <numerusform>затем %n оборота выхаживания</numerusform>
                <numerusform>затем %n оборотов выхаживания</numerusform>
            </translation>
        </message>
        <message>
            <source>Feed,
%1</source>
            <translation>Подача,
%1</translation>
        </message>
        <message>
            <source>Spark-
out</source>
            <translation>Выха-
живание</translation>
        </message>
        <message>
            <source>Time,
s</source>
            <translation>Время,
с</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>да</translation>
        </message>
        <message>
            <source>no</source>
            <translation>нет</translation>
        </message>
    </context>
    <context>
        <name>MeasuredSection</name>
        <message>
            <source>A table of two columns is needed: the angle in °, and the radius in mm or the deviation from it in µm.</source>
            <translation>Нужна таблица из двух столбцов: угол в ° и радиус в мм или отклонение от него в мкм.</translation>
        </message>
        <message>
            <source>Read a measured profile</source>
            <translation>Чтение измеренного профиля</translation>
        </message>
        <message>
            <source>Tables (*.csv *.txt *.tsv *.dat);;All files (*)</source>
            <translation>Таблицы (*.csv *.txt *.tsv *.dat);;Все файлы (*)</translation>
        </message>
        <message>
            <source>The profile was not read</source>
            <translation>Профиль не прочитан</translation>
        </message>
    </context>
    <context>
        <name>sparkout::FormSection</name>
        <message>
            <source>Form by zone</source>
            <translation>Форма по зонам</translation>
        </message>
        <message>
            <source>Form by zone, µm</source>
            <translation>Форма по зонам, мкм</translation>
        </message>
    </context>
    <context>
        <name>DressingText</name>
        <message>
            <source>Parts per dressing</source>
            <translation>Деталей на правку</translation>
        </message>
        <message>
            <source>Limited by</source>
            <translation>Ограничивает</translation>
        </message>
        <message>
            <source>Removed per part</source>
            <translation>Снимается с детали</translation>
        </message>
        <message>
            <source>%1 mm³</source>
            <translation>%1 мм³</translation>
        </message>
        <message>
            <source>Quickest</source>
            <translation>Быстрее всего</translation>
        </message>
        <message>
            <source>after %1 parts: %2 s a part with its share of the dressing</source>
            <translation>правка через %1 дет.: %2 с на деталь с её долей правки</translation>
        </message>
        <message>
            <source>Cheapest</source>
            <translation>Дешевле всего</translation>
        </message>
        <message>
            <source>after %1 parts: %2 a part</source>
            <translation>правка через %1 дет.: %2 на деталь</translation>
        </message>
        <message>
            <source>The wear of the wheel is not given: enter a dulling c or a grinding ratio G.</source>
            <translation>Износ круга не задан: нужно затупление c или коэффициент шлифования G.</translation>
        </message>
        <message>
            <source>The first part after dressing does not reach size.</source>
            <translation>Первая деталь после правки не достигает размера.</translation>
        </message>
        <message>
            <source>any number: the wheel does not get duller, and every part is good</source>
            <translation>сколько угодно: круг больше не тупится, годна каждая деталь</translation>
        </message>
        <message>
            <source>at least %1</source>
            <translation>не менее %1</translation>
        </message>
        <message>
            <source>part %1</source>
            <translation>деталь %1</translation>
        </message>
        <message>
            <source>part %1 of its batch</source>
            <translation>деталь %1 её партии</translation>
        </message>
        <message>
            <source>%1: it does not reach size</source>
            <translation>%1: размер не достигнут</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>%1: %2, %3: %4, limit %5</source>
            <translation>%1: %2, %3: %4, предел %5</translation>
        </message>
    </context>
    <context>
        <name>sparkout::WavesDialog</name>
        <message>
            <source>Waves on a part</source>
            <translation>Волны на детали</translation>
        </message>
        <message>
            <source>none</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>Motors, belts, pumps, the floor: numbers separated by semicolons</source>
            <translation>Двигатели, ремни, насосы, пол: числа через точку с запятой</translation>
        </message>
        <message>
            <source>&amp;Waves counted around the part:</source>
            <translation>&amp;Волн сосчитано вокруг детали:</translation>
        </message>
        <message>
            <source>Known &amp;frequencies, Hz:</source>
            <translation>И&amp;звестные частоты, Гц:</translation>
        </message>
        <message>
            <source>&amp;Close</source>
            <translation>&amp;Закрыть</translation>
        </message>
        <message>
            <source>The part turns with %1 rev/min, the wheel with %2. Other work speed: %3 rev/min; other wheel speed: %4 rev/min.</source>
            <translation>Деталь вращается с частотой %1 об/мин, круг — %2. Другая частота вращения заготовки: %3 об/мин; другая частота вращения круга: %4 об/мин.</translation>
        </message>
    </context>
    <context>
        <name>Waves</name>
        <message>
            <source>a known frequency, %1 Hz</source>
            <translation>известная частота, %1 Гц</translation>
        </message>
        <message>
            <source>chatter at the wheel head’s natural frequency, %1 Hz</source>
            <translation>автоколебания на собственной частоте шлифовальной бабки, %1 Гц</translation>
        </message>
        <message>
            <source>fixed to the work: centres, headstock, blank</source>
            <translation>связано с деталью: центры, передняя бабка, заготовка</translation>
        </message>
        <message>
            <source>the wheel: runout or unbalance</source>
            <translation>круг: биение или дисбаланс</translation>
        </message>
        <message>
            <source>the wheel, with %1 waves around it</source>
            <translation>круг, волн на его окружности: %1</translation>
        </message>
        <message>
            <source>Grind with each of the other speeds in turn and count again: the count of the true cause becomes what is stated here. If the cause is the wheel, force and power ripple off a whole ratio of the speeds and not at it.</source>
            <translation>Прошлифуйте по разу с каждой из других частот вращения и сосчитайте волны снова: при настоящей причине их станет столько, сколько указано здесь. Если причина в круге, сила и мощность пульсируют вне целого отношения частот, а при нём не пульсируют.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::DressingDialog</name>
        <message>
            <source>Parts between dressings</source>
            <translation>Деталей между правками</translation>
        </message>
        <message>
            <source>&amp;Each part must be fit for:</source>
            <translation>&amp;Каждая деталь годна для:</translation>
        </message>
        <message>
            <source>the part as stated</source>
            <translation>детали, как она задана</translation>
        </message>
        <message>
            <source>all corners of the batches</source>
            <translation>всех крайних сочетаний партий</translation>
        </message>
        <message>
            <source>parts of the batches</source>
            <translation>деталей партий</translation>
        </message>
        <message>
            <source>Batches are set up in the view Batch; the dullness follows from the wear.</source>
            <translation>Партии задаются в виде «Партия»; затупление берётся из износа.</translation>
        </message>
        <message>
            <source>&amp;Wheel wear…</source>
            <translation>&amp;Износ круга…</translation>
        </message>
        <message>
            <source>&amp;Close</source>
            <translation>&amp;Закрыть</translation>
        </message>
        <message>
            <source>Stopped before there was a result.</source>
            <translation>Остановлено до получения результата.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::MarginFrontPlot</name>
        <message>
            <source>%1, margin %2 %: %3</source>
            <translation>%1, запас %2 %: %3</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>Margin, %</source>
            <translation>Запас, %</translation>
        </message>
        <message>
            <source>Stages</source>
            <translation>Ступени</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>Цикл</translation>
        </message>
        <message>
            <source>maximum margin by time</source>
            <translation>наибольший запас по времени</translation>
        </message>
        <message>
            <source>your cycle</source>
            <translation>ваш цикл</translation>
        </message>
        <message>
            <source>cycle chosen</source>
            <translation>выбранный цикл</translation>
        </message>
        <message>
            <source>time given</source>
            <translation>заданное время</translation>
        </message>
        <message>
            <source>Machining time</source>
            <translation>Основное время</translation>
        </message>
        <message>
            <source>Minimum margin, %</source>
            <translation>Наименьший запас, %</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LicencesDialog</name>
        <message>
            <source>Licences</source>
            <translation>Лицензии</translation>
        </message>
        <message>
            <source>Components</source>
            <translation>Составные части</translation>
        </message>
        <message>
            <source>Licence</source>
            <translation>Лицензия</translation>
        </message>
        <message>
            <source>C&amp;lose</source>
            <translation>&amp;Закрыть</translation>
        </message>
    </context>
    <context>
        <name>Figure</name>
        <message>
            <source>Cycle time</source>
            <translation>Время цикла</translation>
        </message>
        <message>
            <source>Double strokes or revolutions</source>
            <translation>Двойные ходы или обороты</translation>
        </message>
        <message>
            <source>Maximum minus minimum diameter of the part</source>
            <translation>Разность наибольшего и наименьшего диаметров детали</translation>
        </message>
        <message>
            <source>Cylindricity</source>
            <translation>Отклонение от цилиндричности</translation>
        </message>
        <message>
            <source>Total radial runout</source>
            <translation>Полное радиальное биение</translation>
        </message>
        <message>
            <source>Taper, in radius</source>
            <translation>Конусообразность по радиусу</translation>
        </message>
        <message>
            <source>Barrel (+) or saddle (−) shape, in radius</source>
            <translation>Бочкообразность (+) или седлообразность (−) по радиусу</translation>
        </message>
        <message>
            <source>Maximum normal force</source>
            <translation>Наибольшая нормальная сила</translation>
        </message>
        <message>
            <source>Maximum power</source>
            <translation>Наибольшая мощность</translation>
        </message>
        <message>
            <source>Minimum margin of a requirement</source>
            <translation>Наименьший запас требования</translation>
        </message>
        <message>
            <source>Margin to burn</source>
            <translation>Запас по прижогу</translation>
        </message>
        <message>
            <source>Maximum specific removal rate</source>
            <translation>Наибольшая удельная интенсивность съёма</translation>
        </message>
        <message>
            <source>Specific energy of the cycle</source>
            <translation>Удельная энергия цикла</translation>
        </message>
        <message>
            <source>Double strokes or revolutions of the stage</source>
            <translation>Двойные ходы или обороты ступени</translation>
        </message>
        <message>
            <source>Time of the stage</source>
            <translation>Время ступени</translation>
        </message>
        <message>
            <source>Maximum actual feed of a pass of the stage</source>
            <translation>Наибольшая фактическая подача прохода ступени</translation>
        </message>
        <message>
            <source>Maximum normal force of the stage</source>
            <translation>Наибольшая нормальная сила ступени</translation>
        </message>
        <message>
            <source>Maximum power of the stage</source>
            <translation>Наибольшая мощность ступени</translation>
        </message>
        <message>
            <source>Compliance</source>
            <translation>Податливость</translation>
        </message>
        <message>
            <source>Minimum diameter, deviation</source>
            <translation>Наименьший диаметр, отклонение</translation>
        </message>
        <message>
            <source>Maximum diameter, deviation</source>
            <translation>Наибольший диаметр, отклонение</translation>
        </message>
        <message>
            <source>Mean diameter, deviation</source>
            <translation>Отклонение среднего диаметра</translation>
        </message>
        <message>
            <source>Radial runout</source>
            <translation>Радиальное биение</translation>
        </message>
        <message>
            <source>Roundness</source>
            <translation>Отклонение от круглости</translation>
        </message>
        <message>
            <source>Roughness Ra</source>
            <translation>Шероховатость Ra</translation>
        </message>
        <message>
            <source>Maximum normal force in the zone</source>
            <translation>Наибольшая нормальная сила в зоне</translation>
        </message>
        <message>
            <source>Programmed feed</source>
            <translation>Программная подача</translation>
        </message>
        <message>
            <source>Actual feed</source>
            <translation>Фактическая подача</translation>
        </message>
        <message>
            <source>Programmed minus actual feed, accumulated</source>
            <translation>Отставание накопленной фактической подачи от программной</translation>
        </message>
        <message>
            <source>Accumulated actual feed</source>
            <translation>Накопленная фактическая подача</translation>
        </message>
        <message>
            <source>Stock left, per side</source>
            <translation>Оставшийся припуск на сторону</translation>
        </message>
        <message>
            <source>Normal force</source>
            <translation>Нормальная сила</translation>
        </message>
        <message>
            <source>Equivalent diameter Dₑ</source>
            <translation>Эквивалентный диаметр Dₑ</translation>
        </message>
        <message>
            <source>Shear term of the force law, k_s</source>
            <translation>Коэффициент срезания в законе силы, k_s</translation>
        </message>
        <message>
            <source>Wear-flat term of the force law, k_r</source>
            <translation>Коэффициент трения площадок износа в законе силы, k_r</translation>
        </message>
        <message>
            <source>Maximum actual feed without burn at the finished size</source>
            <translation>Наибольшая фактическая подача без прижога на готовом размере</translation>
        </message>
        <message>
            <source>Maximum minus minimum radius after the pass</source>
            <translation>Разность наибольшего и наименьшего радиусов после прохода</translation>
        </message>
        <message>
            <source>Deepest layer damaged by heat</source>
            <translation>Наибольшая глубина повреждённого нагревом слоя</translation>
        </message>
        <message>
            <source>Maximum actual feed without burn at the stock left</source>
            <translation>Наибольшая фактическая подача без прижога при оставшемся припуске</translation>
        </message>
        <message>
            <source>Rejected parts of the batch</source>
            <translation>Доля негодных деталей партии</translation>
        </message>
        <message>
            <source>Mean over the batch, mean diameter, deviation</source>
            <translation>Среднее по партии отклонение среднего диаметра</translation>
        </message>
        <message>
            <source>Standard deviation over the batch, mean diameter</source>
            <translation>Стандартное отклонение среднего диаметра по партии</translation>
        </message>
        <message>
            <source>Half of the Student interval of the mean, 95 %</source>
            <translation>Половина интервала Стьюдента для среднего, 95 %</translation>
        </message>
        <message>
            <source>Pp of the mean diameter</source>
            <translation>Pp среднего диаметра</translation>
        </message>
        <message>
            <source>Ppk of the mean diameter</source>
            <translation>Ppk среднего диаметра</translation>
        </message>
        <message>
            <source>Time of the quickest cycle of the search, proved</source>
            <translation>Время доказанного самого быстрого цикла поиска</translation>
        </message>
        <message>
            <source>Time of the quickest cycle of whole levels of stock, proved</source>
            <translation>Время доказанного самого быстрого цикла с целыми уровнями припуска</translation>
        </message>
        <message>
            <source>Time of the cycle of dynamic programming</source>
            <translation>Время цикла динамического программирования</translation>
        </message>
        <message>
            <source>Excess of the cycle of dynamic programming over the quickest one</source>
            <translation>Превышение времени цикла динамического программирования над самым быстрым</translation>
        </message>
    </context>
    <context>
        <name>Finding</name>
        <message>
            <source>passed</source>
            <translation>выполнено</translation>
        </message>
        <message>
            <source>not passed</source>
            <translation>не выполнено</translation>
        </message>
        <message>
            <source>not answered</source>
            <translation>нет ответа</translation>
        </message>
        <message>
            <source>for the teacher to mark</source>
            <translation>оценивает преподаватель</translation>
        </message>
        <message>
            <source>locked inputs were changed</source>
            <translation>изменены закрытые исходные данные</translation>
        </message>
        <message>
            <source>the inputs have errors</source>
            <translation>в исходных данных ошибки</translation>
        </message>
        <message>
            <source>the cycle does not end by itself</source>
            <translation>цикл не завершается сам</translation>
        </message>
        <message>
            <source>the run does not give this quantity</source>
            <translation>расчёт не даёт этого показателя</translation>
        </message>
    </context>
    <context>
        <name>Goal</name>
        <message>
            <source>Every requirement must be met for every stock, with a margin of at least {margin} %.</source>
            <translation>Требуется выполнить все требования для всех припусков с запасом не менее {margin} %.</translation>
        </message>
        <message>
            <source>Every requirement must be met, with a margin of at least {margin} %.</source>
            <translation>Требуется выполнить все требования с запасом не менее {margin} %.</translation>
        </message>
        <message>
            <source>Every requirement must be met for every stock.</source>
            <translation>Требуется выполнить все требования для всех припусков.</translation>
        </message>
        <message>
            <source>Every requirement must be met.</source>
            <translation>Требуется выполнить все требования.</translation>
        </message>
        <message>
            <source>The cycle must take at most {time} min.</source>
            <translation>Время цикла — не более {time} мин.</translation>
        </message>
        <message>
            <source>The cycle must take at most {percent} % more than the best one.</source>
            <translation>Время цикла — не более чем на {percent} % больше наименьшего возможного.</translation>
        </message>
        <message>
            <source>Reach {quantity} = {value} ± {tolerance}.</source>
            <translation>Требуется получить: {quantity} = {value} ± {tolerance}.</translation>
        </message>
        <message>
            <source>Determine from the run: {quantity}.</source>
            <translation>Определите по расчёту: {quantity}.</translation>
        </message>
        <message>
            <source>Predict before the run: {quantity}.</source>
            <translation>Предскажите до расчёта: {quantity}.</translation>
        </message>
        <message>
            <source>Draw before the run: {quantity}.</source>
            <translation>Нарисуйте до расчёта: {quantity}.</translation>
        </message>
        <message>
            <source>Predict before the run the order by {quantity}, the largest first.</source>
            <translation>Предскажите до расчёта порядок по убыванию: {quantity}.</translation>
        </message>
        <message>
            <source>One or several answers are right.</source>
            <translation>Верны один или несколько ответов.</translation>
        </message>
        <message>
            <source>Answer in words; the teacher marks the answer.</source>
            <translation>Ответьте словами; ответ проверит преподаватель.</translation>
        </message>
        <message>
            <source>stage {number}</source>
            <translation>ступень {number}</translation>
        </message>
        <message>
            <source>double stroke {number}</source>
            <translation>двойной ход {number}</translation>
        </message>
        <message>
            <source>revolution {number}</source>
            <translation>оборот {number}</translation>
        </message>
        <message>
            <source>required {value} ± {tolerance}</source>
            <translation>требуется {value} ± {tolerance}</translation>
        </message>
        <message>
            <source>answer {value}</source>
            <translation>ответ {value}</translation>
        </message>
        <message>
            <source>result {value}</source>
            <translation>результат {value}</translation>
        </message>
        <message>
            <source>tolerance ± {value}</source>
            <translation>допуск ± {value}</translation>
        </message>
        <message>
            <source>minimum margin {margin} %</source>
            <translation>наименьший запас {margin} %</translation>
        </message>
        <message>
            <source>cycle time {time} min, limit {limit} min</source>
            <translation>время цикла {time} мин, предел {limit} мин</translation>
        </message>
        <message>
            <source>cycle time {time} min</source>
            <translation>время цикла {time} мин</translation>
        </message>
        <message>
            <source>within the tolerance at {share} % of the places, required {least} %</source>
            <translation>в допуске {share} % точек, требуется {least} %</translation>
        </message>
        <message>
            <source>unfit for {share} % of stocks</source>
            <translation>не выполнено для {share} % припусков</translation>
        </message>
        <message>
            <source>not met: {names}</source>
            <translation>не выполнено: {names}</translation>
        </message>
    </context>
    <context>
        <name>GoalText</name>
        <message>
            <source>Double stroke</source>
            <translation>Двойной ход</translation>
        </message>
        <message>
            <source>Revolution</source>
            <translation>Оборот</translation>
        </message>
        <message>
            <source>Stage</source>
            <translation>Ступень</translation>
        </message>
        <message>
            <source>Zone</source>
            <translation>Зона</translation>
        </message>
        <message>
            <source>Section</source>
            <translation>Сечение</translation>
        </message>
    </context>
    <context>
        <name>Grading</name>
        <message>
            <source>cannot be read</source>
            <translation>не читается</translation>
        </message>
        <message>
            <source>of another lesson, or another version of it</source>
            <translation>относится к другой работе или другой её версии</translation>
        </message>
        <message>
            <source>edited outside the program</source>
            <translation>изменено вне программы</translation>
        </message>
        <message>
            <source>identical to the work of another student</source>
            <translation>совпадает с работой другого студента</translation>
        </message>
        <message>
            <source>handed in more than once</source>
            <translation>сдано несколько раз</translation>
        </message>
        <message>
            <source>not on the list</source>
            <translation>нет в списке</translation>
        </message>
        <message>
            <source>kept runs whose numbers are not the engine&apos;s</source>
            <translation>запомненные расчёты с числами не от расчётного ядра</translation>
        </message>
        <message>
            <source>a prediction after the run</source>
            <translation>предсказание после расчёта</translation>
        </message>
        <message>
            <source>locked inputs changed</source>
            <translation>изменены закрытые исходные данные</translation>
        </message>
        <message>
            <source>nothing handed in</source>
            <translation>не сдано</translation>
        </message>
        <message>
            <source>took too long: not all of it was checked</source>
            <translation>проверка заняла слишком много времени: проверено не всё</translation>
        </message>
        <message>
            <source>the name is missing</source>
            <translation>нет имени</translation>
        </message>
        <message>
            <source>this student is listed twice</source>
            <translation>этот студент указан дважды</translation>
        </message>
        <message>
            <source>there are more than 1000</source>
            <translation>их больше 1000</translation>
        </message>
        <message>
            <source>there are no students</source>
            <translation>студентов нет</translation>
        </message>
        <message>
            <source>there are more cells than headings; a name with a comma stands in quotation marks</source>
            <translation>ячеек больше, чем заголовков; имя с запятой пишут в кавычках</translation>
        </message>
    </context>
    <context>
        <name>Variants</name>
        <message>
            <source>another variant has the same inputs</source>
            <translation>такие же исходные данные у другого варианта</translation>
        </message>
        <message>
            <source>the project has errors, or its cycle does not end</source>
            <translation>в проекте ошибки или его цикл не заканчивается</translation>
        </message>
        <message>
            <source>the run does not give a quantity that a step asks for</source>
            <translation>в расчёте нет показателя, о котором спрашивает шаг</translation>
        </message>
        <message>
            <source>a step is solved as given</source>
            <translation>шаг решён заранее</translation>
        </message>
        <message>
            <source>no cycle of the grid meets the goal</source>
            <translation>ни один цикл сетки не выполняет задание</translation>
        </message>
        <message>
            <source>the best answer changes locked inputs</source>
            <translation>лучший ответ меняет закрытые исходные данные</translation>
        </message>
        <message>
            <source>no value of a free input was found that gives the required quantity</source>
            <translation>не найдено значение, дающее заданный показатель</translation>
        </message>
        <message>
            <source>the best answer is too quick compared with the lesson&apos;s</source>
            <translation>лучший ответ слишком быстр по сравнению с исходной работой</translation>
        </message>
        <message>
            <source>the best answer is too slow compared with the lesson&apos;s</source>
            <translation>лучший ответ слишком медленный по сравнению с исходной работой</translation>
        </message>
        <message>
            <source>the best answer&apos;s margin is too far from the lesson&apos;s</source>
            <translation>запас лучшего ответа слишком далёк от исходной работы</translation>
        </message>
        <message>
            <source>a step asks for requirements or a time, and the project has no optimisation whose search could prove an answer</source>
            <translation>шаг требует выполнить требования или время, а в проекте нет оптимизации, поиск которой доказал бы ответ</translation>
        </message>
        <message>
            <source>no cycle of the grid of the lesson&apos;s own project meets every requirement</source>
            <translation>ни один цикл сетки исходного проекта работы не выполняет все требования</translation>
        </message>
        <message>
            <source>a figure is outside the bounds that the lesson sets</source>
            <translation>показатель вне границ, заданных в работе</translation>
        </message>
    </context>
    <context>
        <name>Logo</name>
        <message>
            <source>This picture is damaged and cannot be shown.</source>
            <translation>Рисунок повреждён, показать его нельзя.</translation>
        </message>
        <message>
            <source>An SVG drawing cannot be a logo: a logo is a PNG or JPEG picture of at most %1 pixels a side. Open the drawing in a drawing program or a browser and export it as PNG: in Inkscape by File › Export, on the command line by “rsvg-convert -w 1200 -o logo.png logo.svg”.</source>
            <translation>Рисунок SVG не может быть логотипом: логотип — рисунок PNG или JPEG, не более %1 пикселей по каждой стороне. Откройте его в графическом редакторе или браузере и сохраните как PNG: в Inkscape командой «Файл › Экспортировать», в командной строке «rsvg-convert -w 1200 -o logo.png logo.svg».</translation>
        </message>
        <message>
            <source>This is not a PNG or JPEG picture. A logo has at most %1 pixels a side: open the picture in an image program and save it as PNG.</source>
            <translation>Это не рисунок PNG или JPEG. Логотип — такой рисунок, не более %1 пикселей по каждой стороне: откройте его в графическом редакторе и сохраните как PNG.</translation>
        </message>
        <message>
            <source>The picture has %1 bytes; a logo has at most %2.</source>
            <translation>В рисунке %1 байт; в логотипе допускается не более %2.</translation>
        </message>
        <message>
            <source>The picture has %1 × %2 pixels; a logo has at most %3 a side.</source>
            <translation>В рисунке %1 × %2 пикселей; в логотипе допускается не более %3 по каждой стороне.</translation>
        </message>
    </context>
    <context>
        <name>PackParts</name>
        <message>
            <source>Machine</source>
            <translation>Станок</translation>
        </message>
        <message>
            <source>Wheel</source>
            <translation>Круг</translation>
        </message>
        <message>
            <source>Material</source>
            <translation>Материал</translation>
        </message>
        <message>
            <source>Company and signatures</source>
            <translation>Предприятие и подписи</translation>
        </message>
        <message>
            <source>Laboratory work</source>
            <translation>Лабораторная работа</translation>
        </message>
    </context>
    <context>
        <name>PackPlan</name>
        <message>
            <source>none</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>a picture</source>
            <translation>рисунок</translation>
        </message>
        <message>
            <source>Logo</source>
            <translation>Логотип</translation>
        </message>
        <message>
            <source>Title</source>
            <translation>Название</translation>
        </message>
        <message>
            <source>Steps</source>
            <translation>Шаги</translation>
        </message>
        <message>
            <source>There is no folder for lessons of your own.</source>
            <translation>Папки для собственных лабораторных работ нет.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PackImportDialog</name>
        <message>
            <source>Contents of the pack</source>
            <translation>Что есть в наборе</translation>
        </message>
        <message>
            <source>Item</source>
            <translation>Объект</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Название</translation>
        </message>
        <message>
            <source>You have</source>
            <translation>У вас есть</translation>
        </message>
        <message>
            <source>Action</source>
            <translation>Действие</translation>
        </message>
        <message>
            <source>The chosen line in detail</source>
            <translation>Выбранная строка подробно</translation>
        </message>
        <message>
            <source>Input</source>
            <translation>Исходная величина</translation>
        </message>
        <message>
            <source>Yours</source>
            <translation>У вас</translation>
        </message>
        <message>
            <source>In the pack</source>
            <translation>В наборе</translation>
        </message>
        <message>
            <source>Import a pack</source>
            <translation>Импорт набора</translation>
        </message>
        <message>
            <source>&amp;Import</source>
            <translation>&amp;Импортировать</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>The logo of the pack is left out. %1</source>
            <translation>Логотип из набора не импортируется. %1</translation>
        </message>
        <message>
            <source>Your own data are replaced only if you choose so here. A pack contains only data: nothing in it is executed.</source>
            <translation>Ваше заменяется, только если вы выберете это здесь. В наборе только данные: ничего из него не запускается.</translation>
        </message>
        <message>
            <source>Action for “%1”</source>
            <translation>Что сделать с «%1»</translation>
        </message>
        <message>
            <source>The pack is empty.</source>
            <translation>Набор пуст.</translation>
        </message>
        <message>
            <source>Nothing is chosen.</source>
            <translation>Ничего не выбрано.</translation>
        </message>
        <message>
            <source>Not everything could be kept: %1</source>
            <translation>Сохранить удалось не всё: %1</translation>
        </message>
        <message>
            <source>nothing of that name</source>
            <translation>с таким именем ничего</translation>
        </message>
        <message>
            <source>the one that comes with the program</source>
            <translation>поставляемый с программой</translation>
        </message>
        <message>
            <source>the same</source>
            <translation>то же самое</translation>
        </message>
        <message>
            <source>another of that name</source>
            <translation>другое с таким именем</translation>
        </message>
        <message>
            <source>stays as it is</source>
            <translation>остаётся как есть</translation>
        </message>
        <message>
            <source>Keep yours</source>
            <translation>Оставить ваше</translation>
        </message>
        <message>
            <source>Do not import</source>
            <translation>Не импортировать</translation>
        </message>
        <message>
            <source>Replace yours</source>
            <translation>Заменить ваше</translation>
        </message>
        <message>
            <source>Take</source>
            <translation>Импортировать</translation>
        </message>
        <message>
            <source>Keep both</source>
            <translation>Оставить оба</translation>
        </message>
        <message>
            <source>To be imported: %1.</source>
            <translation>Будет импортировано: %1.</translation>
        </message>
        <message>
            <source>No difference.</source>
            <translation>Различий нет.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PackExportDialog</name>
        <message>
            <source>Works &amp;for students: without right answers and rules of variants</source>
            <translation>Работы &amp;для студентов: без верных ответов и правил вариантов</translation>
        </message>
        <message>
            <source>Export a pack</source>
            <translation>Экспорт набора</translation>
        </message>
        <message>
            <source>&amp;Title:</source>
            <translation>&amp;Название:</translation>
        </message>
        <message>
            <source>&amp;Note:</source>
            <translation>&amp;Примечание:</translation>
        </message>
        <message>
            <source>&amp;Add laboratory works…</source>
            <translation>&amp;Добавить лабораторные работы…</translation>
        </message>
        <message>
            <source>&amp;Save…</source>
            <translation>&amp;Сохранить…</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>Contents of the new pack</source>
            <translation>Что войдёт в набор</translation>
        </message>
        <message>
            <source>Heads of documents</source>
            <translation>Данные для документов</translation>
        </message>
        <message>
            <source>%1, without the logo</source>
            <translation>%1, без логотипа</translation>
        </message>
        <message>
            <source>“%1” is not a laboratory work: %2</source>
            <translation>«%1» — не лабораторная работа: %2</translation>
        </message>
        <message>
            <source>“%1” is too long for a file name or has characters that some systems do not allow.</source>
            <translation>«%1»: имя файла слишком длинное, или в нём есть знаки, которые допускает не каждая система.</translation>
        </message>
        <message>
            <source>“%1” is already in the list.</source>
            <translation>«%1» уже есть в списке.</translation>
        </message>
        <message>
            <source>Add a laboratory work</source>
            <translation>Добавление лабораторной работы</translation>
        </message>
        <message>
            <source>Laboratory works (*.sparkout-lesson)</source>
            <translation>Лабораторные работы (*.sparkout-lesson)</translation>
        </message>
        <message>
            <source>You have nothing to export yet: no entry in the catalogues, no company and no laboratory work.</source>
            <translation>Собственных данных пока нет: ни записей в каталогах, ни предприятия, ни лабораторных работ.</translation>
        </message>
        <message>
            <source>Nothing is chosen.</source>
            <translation>Ничего не выбрано.</translation>
        </message>
        <message>
            <source>To be exported: %1.</source>
            <translation>Войдёт в набор: %1.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::PackCommands</name>
        <message>
            <source>Export a pack</source>
            <translation>Экспорт набора</translation>
        </message>
        <message>
            <source>Pack</source>
            <translation>Набор</translation>
        </message>
        <message>
            <source>Packs (*.sparkout-pack)</source>
            <translation>Наборы (*.sparkout-pack)</translation>
        </message>
        <message>
            <source>Import a pack</source>
            <translation>Импорт набора</translation>
        </message>
        <message>
            <source>Packs (*.sparkout-pack);;All files (*)</source>
            <translation>Наборы (*.sparkout-pack);;Все файлы (*)</translation>
        </message>
        <message>
            <source>Imported from “%1”.</source>
            <translation>Импортировано из «%1».</translation>
        </message>
    </context>
    <context>
        <name>PlotWords</name>
        <message>
            <source>axes: %1</source>
            <translation>оси: %1</translation>
        </message>
        <message>
            <source>shown: %1</source>
            <translation>показано: %1</translation>
        </message>
    </context>
    <context>
        <name>TableText</name>
        <message>
            <source>Table %1 — %2</source>
            <translation>Таблица %1 — %2</translation>
        </message>
        <message>
            <source>Table %1 continued</source>
            <translation>Продолжение таблицы %1</translation>
        </message>
    </context>
    <context>
        <name>PaperWriter</name>
        <message>
            <source>Figure %1 — %2</source>
            <translation>Рисунок %1 — %2</translation>
        </message>
    </context>
    <context>
        <name>StudentView</name>
        <message>
            <source>Symbol</source>
            <translation>Обозначение</translation>
        </message>
        <message>
            <source>Input</source>
            <translation>Исходная величина</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
    </context>
    <context>
        <name>CurveFigure</name>
        <message>
            <source>Predicted</source>
            <translation>Предсказано</translation>
        </message>
        <message>
            <source>By the engine</source>
            <translation>Рассчитано</translation>
        </message>
        <message>
            <source>%1: the prediction beside the engine&apos;s result</source>
            <translation>%1: предсказание и расчёт</translation>
        </message>
        <message>
            <source>A grid to draw on: %1</source>
            <translation>Сетка для построения: %1</translation>
        </message>
    </context>
    <context>
        <name>StepResults</name>
        <message>
            <source>yes</source>
            <translation>да</translation>
        </message>
        <message>
            <source>no</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>Input</source>
            <translation>Исходная величина</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Given</source>
            <translation>Дано</translation>
        </message>
        <message>
            <source>Set</source>
            <translation>Задано</translation>
        </message>
        <message>
            <source>The course of this cycle is in figure %1.</source>
            <translation>Ход этого цикла показан на рисунке %1.</translation>
        </message>
        <message>
            <source>No input was changed.</source>
            <translation>Исходные данные не изменены.</translation>
        </message>
        <message>
            <source>Inputs that were set</source>
            <translation>Заданные исходные данные</translation>
        </message>
        <message>
            <source>Stages of the cycle</source>
            <translation>Ступени цикла</translation>
        </message>
        <message>
            <source>Accuracy by zone or section</source>
            <translation>Точность по зонам или сечениям</translation>
        </message>
        <message>
            <source>Requirements and margins</source>
            <translation>Требования и запасы</translation>
        </message>
        <message>
            <source>Quantity</source>
            <translation>Показатель</translation>
        </message>
        <message>
            <source>Predicted</source>
            <translation>Предсказано</translation>
        </message>
        <message>
            <source>By the engine</source>
            <translation>Рассчитано</translation>
        </message>
        <message>
            <source>Allowed difference</source>
            <translation>Допустимая разность</translation>
        </message>
        <message>
            <source>Prediction and result</source>
            <translation>Предсказание и результат</translation>
        </message>
        <message>
            <source>Difference</source>
            <translation>Разность</translation>
        </message>
        <message>
            <source>Within the allowed difference</source>
            <translation>В пределах допустимой разности</translation>
        </message>
        <message>
            <source>%1: predicted and computed</source>
            <translation>%1: предсказано и рассчитано</translation>
        </message>
        <message>
            <source>Place in the order, the largest first</source>
            <translation>Место по убыванию</translation>
        </message>
        <message>
            <source>The order by %1</source>
            <translation>Порядок по убыванию: %1</translation>
        </message>
        <message>
            <source>Chosen: %1.</source>
            <translation>Выбрано: %1.</translation>
        </message>
        <message>
            <source>No answer was handed in.</source>
            <translation>Ответ не сдан.</translation>
        </message>
        <message>
            <source>Found: %1.</source>
            <translation>Результат проверки: %1.</translation>
        </message>
        <message>
            <source>The cycle takes %1.</source>
            <translation>Время цикла — %1.</translation>
        </message>
        <message>
            <source>Attempts: %1.</source>
            <translation>Попыток: %1.</translation>
        </message>
        <message>
            <source>Hints taken: %1.</source>
            <translation>Взято подсказок: %1.</translation>
        </message>
        <message>
            <source>The prediction was handed in after the run.</source>
            <translation>Предсказание сделано после расчёта.</translation>
        </message>
        <message>
            <source>Step</source>
            <translation>Шаг</translation>
        </message>
        <message>
            <source>Result of the check</source>
            <translation>Результат проверки</translation>
        </message>
        <message>
            <source>curve</source>
            <translation>кривая</translation>
        </message>
        <message>
            <source>%1 of %2 points within the allowed difference</source>
            <translation>в пределах допустимой разности точек: %1 из %2</translation>
        </message>
        <message>
            <source>As given</source>
            <translation>Как дано</translation>
        </message>
        <message>
            <source>Answer</source>
            <translation>Ответ</translation>
        </message>
        <message>
            <source>Answer and result</source>
            <translation>Ответ и результат</translation>
        </message>
    </context>
    <context>
        <name>LabReport</name>
        <message>
            <source>Report on a laboratory work</source>
            <translation>Отчёт по лабораторной работе</translation>
        </message>
        <message>
            <source>Contents</source>
            <translation>Содержание</translation>
        </message>
        <message>
            <source>Introduction</source>
            <translation>Введение</translation>
        </message>
        <message>
            <source>Aim of the work.</source>
            <translation>Цель работы.</translation>
        </message>
        <message>
            <source>The work was done with the program %1. The results below are computed by it from the inputs that were handed in.</source>
            <translation>Работа выполнена в программе %1. Приведённые результаты рассчитаны ею по сданным исходным данным.</translation>
        </message>
        <message>
            <source>Theory in brief</source>
            <translation>Краткая теория</translation>
        </message>
        <message>
            <source>Conclusion</source>
            <translation>Заключение</translation>
        </message>
        <message>
            <source>List of sources used</source>
            <translation>Список использованных источников</translation>
        </message>
        <message>
            <source>Report</source>
            <translation>Отчёт</translation>
        </message>
        <message>
            <source>on a laboratory work</source>
            <translation>по лабораторной работе</translation>
        </message>
        <message>
            <source>on laboratory work No. %1</source>
            <translation>по лабораторной работе № %1</translation>
        </message>
        <message>
            <source>in the discipline “%1”</source>
            <translation>по дисциплине «%1»</translation>
        </message>
        <message>
            <source>“%1”</source>
            <translation>«%1»</translation>
        </message>
        <message>
            <source>Variant %1</source>
            <translation>Вариант %1</translation>
        </message>
        <message>
            <source>Done by the student:</source>
            <translation>Выполнил студент:</translation>
        </message>
        <message>
            <source>Done by the student of group %1:</source>
            <translation>Выполнил студент группы %1:</translation>
        </message>
        <message>
            <source>Accepted by:</source>
            <translation>Принял:</translation>
        </message>
        <message>
            <source>Data of the variant</source>
            <translation>Исходные данные варианта</translation>
        </message>
        <message>
            <source>Variant %1. The inputs of the cycle are those of table 1.</source>
            <translation>Вариант %1. Исходные данные цикла приведены в таблице 1.</translation>
        </message>
        <message>
            <source>The part</source>
            <translation>Деталь</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Исходные данные</translation>
        </message>
        <message>
            <source>Inputs of the surface %1</source>
            <translation>Исходные данные поверхности %1</translation>
        </message>
        <message>
            <source>Results of the work</source>
            <translation>Результаты работы</translation>
        </message>
        <message>
            <source>The results are printed once every prediction is handed in; still open: step %1.</source>
            <translation>Результаты печатаются, когда сданы все предсказания; не сдано: шаг %1.</translation>
        </message>
        <message>
            <source>Step %1</source>
            <translation>Шаг %1</translation>
        </message>
        <message>
            <source>The answer is the conclusion of the work.</source>
            <translation>Ответ приведён в заключении.</translation>
        </message>
        <message>
            <source>Predictions and results</source>
            <translation>Предсказания и результаты</translation>
        </message>
        <message>
            <source>Predictions beside results</source>
            <translation>Предсказания рядом с результатами</translation>
        </message>
        <message>
            <source>Kept runs compared</source>
            <translation>Сравнение запомненных расчётов</translation>
        </message>
        <message>
            <source>The runs that were kept differ in these inputs and results; the numbers are those of the engine.</source>
            <translation>Запомненные расчёты различаются следующими исходными данными и результатами; числа пересчитаны программой.</translation>
        </message>
        <message>
            <source>Kept runs</source>
            <translation>Запомненные расчёты</translation>
        </message>
        <message>
            <source>%1: calculation of cylindrical grinding cycles: a computer program and the description of its model</source>
            <translation>%1: расчёт циклов круглого шлифования: программа для ЭВМ и описание её модели</translation>
        </message>
    </context>
    <context>
        <name>AnswerFields</name>
        <message>
            <source>Input</source>
            <translation>Исходная величина</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Given</source>
            <translation>Дано</translation>
        </message>
        <message>
            <source>Set</source>
            <translation>Задано</translation>
        </message>
        <message>
            <source>Quantity</source>
            <translation>Показатель</translation>
        </message>
        <message>
            <source>Predicted</source>
            <translation>Предсказано</translation>
        </message>
        <message>
            <source>By the engine</source>
            <translation>Рассчитано</translation>
        </message>
        <message>
            <source>Difference</source>
            <translation>Разность</translation>
        </message>
        <message>
            <source>Place in the order, the largest first</source>
            <translation>Место по убыванию</translation>
        </message>
        <message>
            <source>Answer to step %1</source>
            <translation>Ответ к шагу %1</translation>
        </message>
        <message>
            <source>Result:</source>
            <translation>Что получилось:</translation>
        </message>
    </context>
    <context>
        <name>StepKey</name>
        <message>
            <source>Right: %1.</source>
            <translation>Верно: %1.</translation>
        </message>
        <message>
            <source>%1: %2; ± %3 is accepted.</source>
            <translation>%1: %2; принимается ± %3.</translation>
        </message>
        <message>
            <source>%1, the largest first: %2.</source>
            <translation>%1, по убыванию: %2.</translation>
        </message>
        <message>
            <source>By the engine</source>
            <translation>Рассчитано</translation>
        </message>
    </context>
    <context>
        <name>Worksheet</name>
        <message>
            <source>Key to the worksheet</source>
            <translation>Ключ к рабочему листу</translation>
        </message>
        <message>
            <source>Worksheet</source>
            <translation>Рабочий лист</translation>
        </message>
        <message>
            <source>Student</source>
            <translation>Студент</translation>
        </message>
        <message>
            <source>Group</source>
            <translation>Группа</translation>
        </message>
        <message>
            <source>Variant</source>
            <translation>Вариант</translation>
        </message>
        <message>
            <source>Date</source>
            <translation>Дата</translation>
        </message>
        <message>
            <source>For the teacher only. Numbers of formulas and questions are those of the worksheet.</source>
            <translation>Только для преподавателя. Номера формул и вопросов — как в рабочем листе.</translation>
        </message>
        <message>
            <source>The task</source>
            <translation>Задание</translation>
        </message>
        <message>
            <source>Follow one step of the cycle, formula by formula, and find what limits the feed there.</source>
            <translation>Проследите один шаг цикла по формулам и найдите, что ограничивает в нём подачу.</translation>
        </message>
        <message>
            <source>Step %1, points: %2</source>
            <translation>Шаг %1, баллов: %2</translation>
        </message>
        <message>
            <source>The cycle</source>
            <translation>Цикл</translation>
        </message>
        <message>
            <source>Inputs of the formulas</source>
            <translation>Исходные данные формул</translation>
        </message>
        <message>
            <source>The step to work out</source>
            <translation>Разбираемый шаг</translation>
        </message>
        <message>
            <source>Every formula is printed in symbols, then with the given numbers. Fill in the missing ones: insert a computed number wherever it occurs in the next equations.</source>
            <translation>Каждая формула записана в обозначениях, затем с заданными числами. Впишите недостающее: число, найденное по одной формуле, подставляется в следующие.</translation>
        </message>
        <message>
            <source>Sources</source>
            <translation>Источники</translation>
        </message>
        <message>
            <source>Answers to the questions</source>
            <translation>Ответы на вопросы</translation>
        </message>
        <message>
            <source>Questions</source>
            <translation>Вопросы</translation>
        </message>
    </context>
    <context>
        <name>MethodicalGuide</name>
        <message>
            <source>Teaching guide</source>
            <translation>Методические указания</translation>
        </message>
        <message>
            <source>For the teacher only: it contains the answers.</source>
            <translation>Только для преподавателя: содержат ответы.</translation>
        </message>
        <message>
            <source>Aim of the work</source>
            <translation>Цель работы</translation>
        </message>
        <message>
            <source>Theory</source>
            <translation>Теория</translation>
        </message>
        <message>
            <source>Equipment needed</source>
            <translation>Оснащение</translation>
        </message>
        <message>
            <source>A computer for each student with the program %1; no network. The student gets a file of his variant and hands the same file in; the report is printed from it.</source>
            <translation>Компьютер с программой %1 на каждого студента; сеть не нужна. Студент получает файл своего варианта и сдаёт его же; по нему печатается отчёт.</translation>
        </message>
        <message>
            <source>Inputs of the original lesson</source>
            <translation>Исходные данные работы до вариантов</translation>
        </message>
        <message>
            <source>The report</source>
            <translation>Отчёт</translation>
        </message>
        <message>
            <source>The report contains, in the order of GOST 7.32: title page, contents, introduction with the aim, data of the variant, theory in brief, results step by step with tables and figures, predictions beside results, kept runs compared, conclusion in the student&apos;s own words, sources.</source>
            <translation>Отчёт содержит в порядке ГОСТ 7.32: титульный лист, содержание, введение с целью работы, исходные данные варианта, краткую теорию, результаты по шагам с таблицами и рисунками, предсказания рядом с результатами, сравнение запомненных расчётов, заключение словами студента, список источников.</translation>
        </message>
        <message>
            <source>Input that the variants vary</source>
            <translation>Исходная величина, изменяемая по вариантам</translation>
        </message>
        <message>
            <source>Values</source>
            <translation>Значения</translation>
        </message>
        <message>
            <source>%1…%2 in steps of %3</source>
            <translation>%1…%2 с шагом %3</translation>
        </message>
        <message>
            <source>sets of values: %1</source>
            <translation>наборов значений: %1</translation>
        </message>
        <message>
            <source>Variants</source>
            <translation>Варианты</translation>
        </message>
        <message>
            <source>Time norm and points</source>
            <translation>Норма времени и баллы</translation>
        </message>
        <message>
            <source>The work takes %1 min, including the defence.</source>
            <translation>На работу отводится %1 мин, включая защиту.</translation>
        </message>
        <message>
            <source>Step</source>
            <translation>Шаг</translation>
        </message>
        <message>
            <source>Task</source>
            <translation>Задание</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Баллы</translation>
        </message>
        <message>
            <source>Hints, price in points</source>
            <translation>Подсказки, цена в баллах</translation>
        </message>
        <message>
            <source>All</source>
            <translation>Всего</translation>
        </message>
        <message>
            <source>Points of the steps</source>
            <translation>Баллы за шаги</translation>
        </message>
        <message>
            <source>Order of the work</source>
            <translation>Порядок выполнения работы</translation>
        </message>
        <message>
            <source>Step %1</source>
            <translation>Шаг %1</translation>
        </message>
        <message>
            <source>Answer</source>
            <translation>Ответ</translation>
        </message>
        <message>
            <source>Hint %1: %2</source>
            <translation>Подсказка %1: %2</translation>
        </message>
        <message>
            <source>Control questions with answers</source>
            <translation>Контрольные вопросы с ответами</translation>
        </message>
        <message>
            <source>Typical mistakes</source>
            <translation>Типичные ошибки</translation>
        </message>
    </context>
    <context>
        <name>sparkout::TitlePageDialog</name>
        <message>
            <source>Title page of laboratory reports</source>
            <translation>Титульный лист отчётов по лабораторным работам</translation>
        </message>
        <message>
            <source>Printed on the title pages of the reports on laboratory works. All of it may be empty.</source>
            <translation>Печатается на титульных листах отчётов по лабораторным работам. Можно ничего не заполнять.</translation>
        </message>
        <message>
            <source>&amp;Keep</source>
            <translation>&amp;Сохранить</translation>
        </message>
        <message>
            <source>Cance&amp;l</source>
            <translation>Отмена</translation>
        </message>
    </context>
    <context>
        <name>FormAccess</name>
        <message>
            <source>Locked until the prediction is given.</source>
            <translation>Закрыто, пока не дан прогноз.</translation>
        </message>
        <message>
            <source>Locked in this step of the laboratory work.</source>
            <translation>Закрыто на этом шаге лабораторной работы.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ChoiceAnswer</name>
        <message>
            <source>Tick every correct answer; there may be more than one.</source>
            <translation>Отметьте верные ответы; их может быть несколько.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::CurveAnswer</name>
        <message>
            <source>Click into the plot for each point, or type the values below it.</source>
            <translation>Поставьте точки щелчками на графике или введите значения под ним.</translation>
        </message>
        <message>
            <source>The axis goes up to</source>
            <translation>Ось до</translation>
        </message>
        <message>
            <source>The axis goes up to, %1</source>
            <translation>Ось до, %1</translation>
        </message>
        <message>
            <source>%1 and value</source>
            <translation>%1 и значение</translation>
        </message>
        <message>
            <source>%1 %2: %3</source>
            <translation>%1 %2: %3</translation>
        </message>
        <message>
            <source>prediction</source>
            <translation>прогноз</translation>
        </message>
        <message>
            <source>result</source>
            <translation>результат</translation>
        </message>
        <message>
            <source>Your curve: %1</source>
            <translation>Ваша кривая: %1</translation>
        </message>
        <message>
            <source>Left and Right choose a place, Up and Down move its point, Del removes it.</source>
            <translation>Стрелки влево и вправо выбирают место, вверх и вниз двигают точку, Del убирает её.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LessonDesk</name>
        <message>
            <source>The work is not saved. %1</source>
            <translation>Работа не сохранена. %1</translation>
        </message>
        <message>
            <source>%1 copy</source>
            <translation>%1 (копия)</translation>
        </message>
        <message>
            <source>The work is not saved: the answers handed in are only in this window.</source>
            <translation>Работа не сохранена: сданное есть только в этом окне.</translation>
        </message>
        <message>
            <source>“%1” is open read-only. Answers handed in are saved to another file.</source>
            <translation>«%1» открыт только для чтения. При сдаче ответа будет спрошен другой файл.</translation>
        </message>
        <message>
            <source>“%1” was changed or removed by another program while it is open here. Saving will ask which version counts.</source>
            <translation>«%1» изменён или удалён другой программой, пока он открыт здесь. При сохранении будет спрошено, какая версия верна.</translation>
        </message>
        <message>
            <source>Try again</source>
            <translation>Повторить</translation>
        </message>
        <message>
            <source>Save elsewhere…</source>
            <translation>Сохранить в другое место…</translation>
        </message>
        <message>
            <source>The file was not opened</source>
            <translation>Файл не открыт</translation>
        </message>
        <message>
            <source>Keep the work in</source>
            <translation>Файл работы</translation>
        </message>
        <message>
            <source>Works (*%1)</source>
            <translation>Работы студентов (*%1)</translation>
        </message>
        <message>
            <source>Making the variant</source>
            <translation>Составление варианта</translation>
        </message>
        <message>
            <source>The lesson cannot be started</source>
            <translation>Работу нельзя начать</translation>
        </message>
        <message>
            <source>This variant does not exist</source>
            <translation>Такого варианта нет</translation>
        </message>
        <message>
            <source>The lesson has %1 variants.</source>
            <translation>Вариантов в работе: %1.</translation>
        </message>
        <message>
            <source>This work was changed outside the program. The teacher will see it.</source>
            <translation>Файл работы изменён вне программы. Преподаватель это увидит.</translation>
        </message>
        <message>
            <source>Opened: %1</source>
            <translation>Открыто: %1</translation>
        </message>
        <message>
            <source>Saved.</source>
            <translation>Сохранено.</translation>
        </message>
        <message>
            <source>The work is not saved</source>
            <translation>Работа не сохранена</translation>
        </message>
        <message>
            <source>trial</source>
            <translation>проба</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LessonPanel</name>
        <message>
            <source>Step %1: %2, points: %3 of %4</source>
            <translation>Шаг %1: %2, баллы: %3 из %4</translation>
        </message>
        <message>
            <source>Step %1: %2, points: %3</source>
            <translation>Шаг %1: %2, баллы: %3</translation>
        </message>
        <message>
            <source>Points: %1 of %2</source>
            <translation>Баллы: %1 из %2</translation>
        </message>
        <message>
            <source>Your first prediction counts. The result is shown once you have given it.</source>
            <translation>Засчитывается первый прогноз; после него появится результат расчёта.</translation>
        </message>
        <message>
            <source>Submit prediction</source>
            <translation>Дать прогноз</translation>
        </message>
        <message>
            <source>Hand in</source>
            <translation>Ответить</translation>
        </message>
        <message>
            <source>Check</source>
            <translation>Проверить</translation>
        </message>
        <message>
            <source>Being checked…</source>
            <translation>Проверяется…</translation>
        </message>
        <message>
            <source>Attempts: %1</source>
            <translation>Попытки: %1</translation>
        </message>
        <message>
            <source>&lt;b&gt;Hint %1&lt;/b&gt; (−%2): %3</source>
            <translation>&lt;b&gt;Подсказка %1&lt;/b&gt; (−%2): %3</translation>
        </message>
        <message>
            <source>Hint %1 of %2, price in points: %3</source>
            <translation>Подсказка %1 из %2, цена в баллах: %3</translation>
        </message>
        <message>
            <source>Task</source>
            <translation>Задание</translation>
        </message>
        <message>
            <source>Aim and theory</source>
            <translation>Цель и теория</translation>
        </message>
        <message>
            <source>Steps of the laboratory work</source>
            <translation>Шаги лабораторной работы</translation>
        </message>
        <message>
            <source>Previous step</source>
            <translation>Предыдущий шаг</translation>
        </message>
        <message>
            <source>Next step</source>
            <translation>Следующий шаг</translation>
        </message>
        <message>
            <source>%1, variant %2</source>
            <translation>%1, вариант %2</translation>
        </message>
        <message>
            <source>%1, group %2, variant %3</source>
            <translation>%1, группа %2, вариант %3</translation>
        </message>
        <message>
            <source>Aim</source>
            <translation>Цель работы</translation>
        </message>
        <message>
            <source>Theory</source>
            <translation>Теория</translation>
        </message>
        <message>
            <source>Task, aim and theory</source>
            <translation>Задание, цель и теория</translation>
        </message>
        <message>
            <source>Take a hint</source>
            <translation>Взять подсказку</translation>
        </message>
        <message>
            <source>Some views stay hidden until the predictions they would reveal are given.</source>
            <translation>Некоторые виды скрыты, пока не даны прогнозы: в них виден ответ.</translation>
        </message>
    </context>
    <context>
        <name>LessonText</name>
        <message>
            <source>open</source>
            <translation>не выполнен</translation>
        </message>
        <message>
            <source>being checked</source>
            <translation>проверяется</translation>
        </message>
        <message>
            <source>done</source>
            <translation>выполнен</translation>
        </message>
        <message>
            <source>not passed</source>
            <translation>не зачтён</translation>
        </message>
        <message>
            <source>handed in</source>
            <translation>сдан</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LessonsDialog</name>
        <message>
            <source>Laboratory works</source>
            <translation>Лабораторные работы</translation>
        </message>
        <message>
            <source>About the laboratory work</source>
            <translation>О лабораторной работе</translation>
        </message>
        <message>
            <source>&amp;Begin…</source>
            <translation>&amp;Начать…</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>Steps: %1. Points: %2.</source>
            <translation>Шагов: %1. Баллов: %2.</translation>
        </message>
    </context>
    <context>
        <name>sparkout::MarksDialog</name>
        <message>
            <source>Mark works</source>
            <translation>Проверка работ</translation>
        </message>
        <message>
            <source>Marks</source>
            <translation>Баллы</translation>
        </message>
        <message>
            <source>The work by its steps</source>
            <translation>Работа по шагам</translation>
        </message>
        <message>
            <source>&amp;Lesson…</source>
            <translation>&amp;Лабораторная работа…</translation>
        </message>
        <message>
            <source>&amp;Work…</source>
            <translation>&amp;Работа студента…</translation>
        </message>
        <message>
            <source>Works of a &amp;folder…</source>
            <translation>Работы из &amp;папки…</translation>
        </message>
        <message>
            <source>List or &amp;table…</source>
            <translation>&amp;Список или таблица…</translation>
        </message>
        <message>
            <source>&amp;Mark</source>
            <translation>Проверит&amp;ь</translation>
        </message>
        <message>
            <source>&amp;Stop</source>
            <translation>&amp;Остановить</translation>
        </message>
        <message>
            <source>&amp;Export CSV…</source>
            <translation>&amp;Экспорт CSV…</translation>
        </message>
        <message>
            <source>Lesson: %1</source>
            <translation>Лабораторная работа: %1</translation>
        </message>
        <message>
            <source>Lesson: none yet. Drop it here, or choose it.</source>
            <translation>Лабораторная работа не выбрана. Перетащите её файл сюда или выберите его.</translation>
        </message>
        <message>
            <source>Works: none yet. Drop files or a folder here, or choose them.</source>
            <translation>Работ студентов нет. Перетащите сюда файлы или папку либо выберите их.</translation>
        </message>
        <message>
            <source>Works: %1</source>
            <translation>Работ студентов: %1</translation>
        </message>
        <message>
            <source>Stopped: %1 of %2 works are marked.</source>
            <translation>Остановлено: проверено работ — %1 из %2.</translation>
        </message>
        <message>
            <source>List of students: %1</source>
            <translation>В списке студентов: %1</translation>
        </message>
        <message>
            <source>Table of best answers: %1 variants</source>
            <translation>Таблица лучших ответов, вариантов: %1</translation>
        </message>
        <message>
            <source>%1, line %2: %3.</source>
            <translation>%1, строка %2: %3.</translation>
        </message>
        <message>
            <source>There are more than %1 works; only the first ones are marked.</source>
            <translation>Работ больше %1; взяты первые.</translation>
        </message>
        <message>
            <source>Not accepted</source>
            <translation>Не принято</translation>
        </message>
        <message>
            <source>The lesson</source>
            <translation>Лабораторная работа</translation>
        </message>
        <message>
            <source>Lessons (*.%1)</source>
            <translation>Лабораторные работы (*.%1)</translation>
        </message>
        <message>
            <source>One of the works of the folder</source>
            <translation>Одна из работ папки</translation>
        </message>
        <message>
            <source>A work</source>
            <translation>Работа студента</translation>
        </message>
        <message>
            <source>Works (*.%1)</source>
            <translation>Работы студентов (*.%1)</translation>
        </message>
        <message>
            <source>List of students or table of best answers</source>
            <translation>Список студентов или таблица лучших ответов</translation>
        </message>
        <message>
            <source>Tables (*.csv);;All files (*)</source>
            <translation>Таблицы (*.csv);;Все файлы (*)</translation>
        </message>
        <message>
            <source>%1 of %2 points</source>
            <translation>баллы: %1 из %2</translation>
        </message>
        <message>
            <source>Step %1, points: %2 of %3. %4</source>
            <translation>Шаг %1, баллы: %2 из %3. %4</translation>
        </message>
        <message>
            <source>Hints: −%1.</source>
            <translation>Подсказки: −%1.</translation>
        </message>
        <message>
            <source>Export the marks</source>
            <translation>Экспорт баллов</translation>
        </message>
        <message>
            <source>marks</source>
            <translation>баллы</translation>
        </message>
        <message>
            <source>Tables (*.csv)</source>
            <translation>Таблицы (*.csv)</translation>
        </message>
        <message>
            <source>Export &amp;XLSX…</source>
            <translation>Э&amp;кспорт XLSX…</translation>
        </message>
    </context>
    <context>
        <name>MarksTable</name>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Student</source>
            <translation>Студент</translation>
        </message>
        <message>
            <source>Group</source>
            <translation>Группа</translation>
        </message>
        <message>
            <source>Variant</source>
            <translation>Вариант</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>Баллы</translation>
        </message>
        <message>
            <source>of</source>
            <translation>из</translation>
        </message>
        <message>
            <source>To be marked</source>
            <translation>Оценить</translation>
        </message>
        <message>
            <source>Time, min</source>
            <translation>Время, мин</translation>
        </message>
        <message>
            <source>Remarks</source>
            <translation>Замечания</translation>
        </message>
        <message>
            <source>Step %1</source>
            <translation>Шаг %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::NumberAnswer</name>
        <message>
            <source>Your prediction</source>
            <translation>Ваш прогноз</translation>
        </message>
        <message>
            <source>Your prediction: %1</source>
            <translation>Ваш прогноз: %1</translation>
        </message>
        <message>
            <source>Result of the run</source>
            <translation>Результат расчёта</translation>
        </message>
        <message>
            <source>Your answer</source>
            <translation>Ваш ответ</translation>
        </message>
        <message>
            <source>Your answer: %1</source>
            <translation>Ваш ответ: %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::OrderAnswer</name>
        <message>
            <source>Your prediction, the largest first</source>
            <translation>Ваш прогноз, от наибольшего</translation>
        </message>
        <message>
            <source>The largest first: drag them, or move them with the buttons.</source>
            <translation>От наибольшего к наименьшему: перетащите или переставьте кнопками.</translation>
        </message>
        <message>
            <source>Result of the run, the largest first</source>
            <translation>Результат расчёта, от наибольшего</translation>
        </message>
        <message>
            <source>Move up</source>
            <translation>Выше</translation>
        </message>
        <message>
            <source>Ctrl+Up</source>
            <translation>Ctrl+↑</translation>
        </message>
        <message>
            <source>Move down</source>
            <translation>Ниже</translation>
        </message>
        <message>
            <source>Ctrl+Down</source>
            <translation>Ctrl+↓</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StudentDialog</name>
        <message>
            <source>Begin the laboratory work</source>
            <translation>Начать лабораторную работу</translation>
        </message>
        <message>
            <source>Next you choose the file of your work; hand in that file. Every answer is saved in it at once.</source>
            <translation>Далее выберите файл, в котором хранится работа: его вы и сдаёте. Каждый ответ сразу сохраняется в нём.</translation>
        </message>
        <message>
            <source>&amp;Surname and first name</source>
            <translation>&amp;Фамилия и имя</translation>
        </message>
        <message>
            <source>&amp;Group</source>
            <translation>&amp;Группа</translation>
        </message>
        <message>
            <source>&amp;Variant</source>
            <translation>&amp;Вариант</translation>
        </message>
        <message>
            <source>&amp;Begin…</source>
            <translation>&amp;Начать…</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
    </context>
    <context>
        <name>sparkout::TextAnswer</name>
        <message>
            <source>%1 of at least %2 characters. Your teacher reads the answer.</source>
            <translation>Знаков: %1, нужно не менее %2. Ответ читает преподаватель.</translation>
        </message>
        <message>
            <source>Your answer</source>
            <translation>Ваш ответ</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LessonWiring</name>
        <message>
            <source>The views are covered until you have given your prediction in the panel of the laboratory work. Then the result is shown beside it.</source>
            <translation>Виды закрыты, пока вы не дали прогноз на панели лабораторной работы. Затем результат появится рядом с ним.</translation>
        </message>
        <message>
            <source>Best answer of the laboratory work</source>
            <translation>Наилучший ответ лабораторной работы</translation>
        </message>
    </context>
    <context>
        <name>RunName</name>
        <message>
            <source>Run %1</source>
            <translation>Расчёт %1</translation>
        </message>
        <message>
            <source>Worst part, no. %1</source>
            <translation>Худшая деталь, № %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LessonDraft</name>
        <message>
            <source>Project</source>
            <translation>Проект</translation>
        </message>
    </context>
    <context>
        <name>sparkout::StructForm</name>
        <message>
            <source>Add: %1</source>
            <translation>Добавить: %1</translation>
        </message>
        <message>
            <source>Up</source>
            <translation>Выше</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Удалить</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LessonForm</name>
        <message>
            <source>Kind of goal</source>
            <translation>Вид цели</translation>
        </message>
        <message>
            <source>Varied over</source>
            <translation>Варьируется</translation>
        </message>
        <message>
            <source>a range in steps</source>
            <translation>по диапазону с шагом</translation>
        </message>
        <message>
            <source>a list of values</source>
            <translation>по списку значений</translation>
        </message>
        <message>
            <source>named sets of values</source>
            <translation>по именованным наборам</translation>
        </message>
        <message>
            <source>Total variants: %1</source>
            <translation>Всего вариантов: %1</translation>
        </message>
        <message>
            <source>Levels: %1</source>
            <translation>Уровней: %1</translation>
        </message>
        <message>
            <source>the current one</source>
            <translation>открытый</translation>
        </message>
    </context>
    <context>
        <name>sparkout::AccessPage</name>
        <message>
            <source>as the inputs around them</source>
            <translation>как у данных вокруг</translation>
        </message>
        <message>
            <source>Search the inputs</source>
            <translation>Поиск исходных данных</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Исходные данные</translation>
        </message>
        <message>
            <source>Input</source>
            <translation>Исходная величина</translation>
        </message>
        <message>
            <source>For the student</source>
            <translation>Для студента</translation>
        </message>
        <message>
            <source>Selected inputs</source>
            <translation>Выделенные</translation>
        </message>
    </context>
    <context>
        <name>sparkout::TextPreview</name>
        <message>
            <source>Language of the preview</source>
            <translation>Язык просмотра</translation>
        </message>
        <message>
            <source>As the student reads it</source>
            <translation>Как это читает студент</translation>
        </message>
    </context>
    <context>
        <name>sparkout::LessonPage</name>
        <message>
            <source>Title, aim, theory</source>
            <translation>Название, цель, теория</translation>
        </message>
        <message>
            <source>For the teacher</source>
            <translation>Преподавателю</translation>
        </message>
        <message>
            <source>Task</source>
            <translation>Задание</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>Данные</translation>
        </message>
        <message>
            <source>Values</source>
            <translation>Значения</translation>
        </message>
        <message>
            <source>Hidden</source>
            <translation>Скрыто</translation>
        </message>
        <message>
            <source>Goal</source>
            <translation>Цель</translation>
        </message>
        <message>
            <source>Hints</source>
            <translation>Подсказки</translation>
        </message>
        <message>
            <source>Moment</source>
            <translation>Момент</translation>
        </message>
        <message>
            <source>Views, panels and commands that the step hides</source>
            <translation>Виды, панели и команды, скрытые на шаге</translation>
        </message>
        <message>
        <source>Variants</source>
        <translation>Варианты</translation>
    </message>
    <message>
        <source>Chec&amp;k variants…</source>
        <translation>Проверить вариант&amp;ы…</translation>
    </message>
    <message>
        <source>Make some of the variants and see their best answers, or why one is refused; nothing is saved</source>
        <translation>Составить несколько вариантов и показать лучшие ответы или причины отказа; ничего не сохраняется</translation>
    </message>
    </context>
    <context>
        <name>sparkout::LessonEditor</name>
        <message>
            <source>Lessons (*%1)</source>
            <translation>Лабораторные работы (*%1)</translation>
        </message>
        <message>
            <source>&amp;New</source>
            <translation>&amp;Создать</translation>
        </message>
        <message>
            <source>A new laboratory work about the project in the window</source>
            <translation>Новая лабораторная работа по проекту в окне</translation>
        </message>
        <message>
            <source>&amp;Open…</source>
            <translation>&amp;Открыть…</translation>
        </message>
        <message>
            <source>Open a laboratory work</source>
            <translation>Открыть лабораторную работу</translation>
        </message>
        <message>
            <source>&amp;Copy of…</source>
            <translation>По об&amp;разцу…</translation>
        </message>
        <message>
            <source>A new laboratory work based on an existing one</source>
            <translation>Новая работа по образцу имеющейся</translation>
        </message>
        <message>
            <source>&amp;Save</source>
            <translation>&amp;Сохранить</translation>
        </message>
        <message>
            <source>Save the laboratory work</source>
            <translation>Сохранить лабораторную работу</translation>
        </message>
        <message>
            <source>Save &amp;as…</source>
            <translation>Сохранить &amp;как…</translation>
        </message>
        <message>
            <source>Save the laboratory work in another file</source>
            <translation>Сохранить лабораторную работу в другой файл</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>&amp;Отменить</translation>
        </message>
        <message>
            <source>Undo the last change</source>
            <translation>Отменить последнее изменение</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>&amp;Повторить</translation>
        </message>
        <message>
            <source>Redo the change</source>
            <translation>Вернуть отменённое изменение</translation>
        </message>
        <message>
            <source>Use the &amp;project</source>
            <translation>&amp;Включить проект</translation>
        </message>
        <message>
            <source>The project in the window becomes that of the laboratory work</source>
            <translation>Проект в окне становится проектом работы</translation>
        </message>
        <message>
            <source>S&amp;how the project</source>
            <translation>Показать про&amp;ект</translation>
        </message>
        <message>
            <source>Opens the project of the laboratory work in the window for editing</source>
            <translation>Проект работы открывается в окне, чтобы его изменить</translation>
        </message>
        <message>
            <source>&amp;Try as a student</source>
            <translation>&amp;Испытать</translation>
        </message>
        <message>
            <source>Do the laboratory work in the window, beginning with the current step</source>
            <translation>Выполнить работу в окне, как студент, с открытого шага</translation>
        </message>
        <message>
            <source>A&amp;dd a step</source>
            <translation>&amp;Добавить шаг</translation>
        </message>
        <message>
            <source>Adds a step after the current one</source>
            <translation>Добавить шаг после текущего</translation>
        </message>
        <message>
            <source>Dup&amp;licate</source>
            <translation>Копирова&amp;ть</translation>
        </message>
        <message>
            <source>Duplicates the step</source>
            <translation>Создать копию шага</translation>
        </message>
        <message>
            <source>Earl&amp;ier</source>
            <translation>Р&amp;аньше</translation>
        </message>
        <message>
            <source>Moves the step up</source>
            <translation>Переместить шаг выше</translation>
        </message>
        <message>
            <source>Lat&amp;er</source>
            <translation>По&amp;зже</translation>
        </message>
        <message>
            <source>Moves the step down</source>
            <translation>Переместить шаг ниже</translation>
        </message>
        <message>
            <source>Re&amp;move</source>
            <translation>&amp;Удалить</translation>
        </message>
        <message>
            <source>Remove the step</source>
            <translation>Удалить шаг</translation>
        </message>
        <message>
            <source>The file was not opened</source>
            <translation>Файл не открыт</translation>
        </message>
        <message>
            <source>The laboratory work has faults</source>
            <translation>В работе есть ошибки</translation>
        </message>
        <message>
            <source>They are listed below the pages; a double click leads to each of them.</source>
            <translation>Они перечислены внизу; двойной щелчок ведёт к каждой.</translation>
        </message>
        <message>
            <source>The laboratory work is not saved</source>
            <translation>Лабораторная работа не сохранена</translation>
        </message>
        <message>
            <source>Unsaved changes</source>
            <translation>Несохранённые изменения</translation>
        </message>
        <message>
            <source>The laboratory work “%1” has changes that are not saved.</source>
            <translation>В лабораторной работе «%1» есть несохранённые изменения.</translation>
        </message>
        <message>
            <source>&amp;Do not save</source>
            <translation>&amp;Не сохранять</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>not saved yet</source>
            <translation>ещё не сохранена</translation>
        </message>
        <message>
            <source>The work as a whole</source>
            <translation>Работа в целом</translation>
        </message>
        <message>
            <source>Step %1. %2</source>
            <translation>Шаг %1. %2</translation>
        </message>
        <message>
            <source>Laboratory work: %1[*]</source>
            <translation>Лабораторная работа: %1[*]</translation>
        </message>
        <message>
            <source>Laboratory work: %1[*] (read-only)</source>
            <translation>Лабораторная работа: %1[*] (только для чтения)</translation>
        </message>
        <message>
            <source>No faults: the laboratory work can be saved and tried.</source>
            <translation>Ошибок нет: работу можно сохранить и испытать.</translation>
        </message>
        <message>
            <source>The work and its steps</source>
            <translation>Работа и её шаги</translation>
        </message>
        <message>
            <source>Faults of the laboratory work</source>
            <translation>Ошибки лабораторной работы</translation>
        </message>
        <message>
            <source>Printin&amp;g</source>
            <translation>Пе&amp;чать</translation>
        </message>
        <message>
            <source>Worksheet, its key and the teaching guide of the laboratory work</source>
            <translation>Рабочий лист, ключ к нему и методические указания к работе</translation>
        </message>
    </context>
    <context>
        <name>ReportActions</name>
        <message>
            <source>Print previe&amp;w…</source>
            <translation>Предварительный прос&amp;мотр…</translation>
        </message>
        <message>
            <source>&amp;Print…</source>
            <translation>Пе&amp;чать…</translation>
        </message>
        <message>
            <source>Export P&amp;DF…</source>
            <translation>Экспорт P&amp;DF…</translation>
        </message>
        <message>
            <source>Export &amp;HTML…</source>
            <translation>Экспорт &amp;HTML…</translation>
        </message>
        <message>
            <source>Export &amp;Markdown…</source>
            <translation>Экспорт &amp;Markdown…</translation>
        </message>
        <message>
            <source>Export &amp;ODT…</source>
            <translation>Экспорт &amp;ODT…</translation>
        </message>
    </context>
    <context>
        <name>sparkout::ReportOutput</name>
        <message>
            <source>Print preview: %1</source>
            <translation>Предварительный просмотр: %1</translation>
        </message>
        <message>
            <source>Print: %1</source>
            <translation>Печать: %1</translation>
        </message>
        <message>
            <source>PDF documents (*.pdf)</source>
            <translation>Документы PDF (*.pdf)</translation>
        </message>
        <message>
            <source>Web pages (*.html)</source>
            <translation>Веб-страницы (*.html)</translation>
        </message>
        <message>
            <source>Markdown texts (*.md)</source>
            <translation>Тексты Markdown (*.md)</translation>
        </message>
        <message>
            <source>OpenDocument texts (*.odt)</source>
            <translation>Тексты OpenDocument (*.odt)</translation>
        </message>
        <message>
            <source>Not printed</source>
            <translation>Не напечатано</translation>
        </message>
        <message>
            <source>Output failed. Check printer and disk.</source>
            <translation>Вывод не удался. Проверьте принтер и диск.</translation>
        </message>
        <message>
            <source>Export: %1</source>
            <translation>Экспорт: %1</translation>
        </message>
    </context>
    <context>
        <name>Paper</name>
        <message>
            <source>Laboratory &amp;report</source>
            <translation>От&amp;чёт по лабораторной работе</translation>
        </message>
        <message>
            <source>Wor&amp;ksheet</source>
            <translation>Ра&amp;бочий лист</translation>
        </message>
        <message>
            <source>Key to the &amp;worksheet</source>
            <translation>&amp;Ключ к рабочему листу</translation>
        </message>
        <message>
            <source>Methodical &amp;guide</source>
            <translation>&amp;Методические указания</translation>
        </message>
    </context>
    <context>
        <name>sparkout::VariantCheckDialog</name>
    <message>
        <source>Check variants</source>
        <translation>Проверка вариантов</translation>
    </message>
    <message>
        <source>&amp;Make</source>
        <translation>&amp;Составить</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Остановить</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Закрыть</translation>
    </message>
    <message>
        <source>&amp;Number of variants</source>
        <translation>&amp;Число вариантов</translation>
    </message>
    <message>
        <source>Variants and refused tries</source>
        <translation>Варианты и отклонённые попытки</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Вариант</translation>
    </message>
    <message>
        <source>Best time, min</source>
        <translation>Лучшее время, мин</translation>
    </message>
    <message>
        <source>Margin, %</source>
        <translation>Запас, %</translation>
    </message>
    <message>
        <source>Reason for refusal</source>
        <translation>Причина отказа</translation>
    </message>
    <message>
        <source>Searching for the best answer of the original work…</source>
        <translation>Ищется лучший ответ исходной работы…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Остановлено.</translation>
    </message>
    <message>
        <source>Tried: %1, variants: %2</source>
        <translation>Попыток: %1, вариантов: %2</translation>
    </message>
    <message>
        <source>The original work: best time %1 min, margin %2 %</source>
        <translation>Исходная работа: лучшее время %1 мин, запас %2 %</translation>
    </message>
    </context>
    <context>
        <name>WheelWidths</name>
        <message>
            <source>to traverse {value} mm (overruns of a third at most)</source>
            <translation>с продольной подачей – {value} мм (перебеги не больше трети ширины)</translation>
        </message>
        <message>
            <source>to plunge {value} mm</source>
            <translation>врезанием – {value} мм</translation>
        </message>
        <message>
            <source>no wheel of the catalogue fits</source>
            <translation>в каталоге нет подходящего круга</translation>
        </message>
        <message>
            <source>widths of the catalogue&apos;s wheels that fit: {value}</source>
            <translation>подходящая ширина кругов каталога: {value}</translation>
        </message>
    </context>
    <context>
        <name>Pages</name>
        <message>
            <source>Inputs of this document</source>
            <translation>Исходные данные этого документа</translation>
        </message>
    </context>
    <context>
        <name>Report</name>
        <message>
            <source>Surface of the part</source>
            <translation>Поверхность детали</translation>
        </message>
        <message>
            <source>surface %1</source>
            <translation>поверхность %1</translation>
        </message>
    </context>
    <context>
        <name>sparkout::KeywayHelper</name>
        <message>
            <source>This is not a keyway with width and length; write it like 12P9 × 45, or with the angle of its first edge like 12P9 × 45, 90°.</source>
            <translation>Не паз по ширине и длине; пишется как 12P9 × 45 или с углом первой кромки: 12P9 × 45, 90°.</translation>
        </message>
        <message>
            <source>The diameter is needed first.</source>
            <translation>Сначала нужен диаметр.</translation>
        </message>
        <message>
            <source>A keyway of %1 mm is not narrower than the diameter of %2 mm.</source>
            <translation>Шпоночный паз %1 мм не уже диаметра %2 мм.</translation>
        </message>
        <message>
            <source>%1 mm on ∅%2 mm: a gap of %3°, from %4° on.</source>
            <translation>%1 мм на ∅%2 мм: паз %3°, начиная с %4°.</translation>
        </message>
        <message>
            <source>It is %1 mm long; in the model it extends over the whole ground length of %2 mm.</source>
            <translation>Длина паза %1 мм; в модели он идёт по всей шлифуемой длине %2 мм.</translation>
        </message>
        <message>
            <source>Keyway, width × length</source>
            <translation>Шпоночный паз, ширина × длина</translation>
        </message>
        <message>
            <source>12P9 × 45 makes a gap of the surface; 12P9 × 45, 90° also sets the angle of its first edge</source>
            <translation>12P9 × 45 даёт паз поверхности; 12P9 × 45, 90° задаёт и угол его первой кромки</translation>
        </message>
        <message>
            <source>Keyway in the model</source>
            <translation>Чем паз является в модели</translation>
        </message>
    </context>
</TS>
