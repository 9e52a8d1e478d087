# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2154
# The window and the installer under Wine: packaging/windows/try reads this once it has tried the
# command line. What is tried is what the zip holds, in a folder with Cyrillic letters in its name.

release=$(basename "$out"/sparkout-[0-9]*-windows-x86_64.zip .zip)
user=$WINEPREFIX/drive_c/users/$(id -un)/AppData
window_linux=$(dirname "$linux")/sparkout
place="$work/Программы цеха/$release"
pictures=$work/pictures
unset QT_QPA_PLATFORM

window() { wine "$place/sparkout.exe" "$@"; }

start_window() { # LOG WORDS…: beside this, without a word of the shell when it is ended
    local log=windows/$1
    shift
    (exec wine "$place/sparkout.exe" "$@" >>"$log" 2>&1) &
    disown
}

# The text of the title of a window that stands on the screen; they are asked once more a while.
await_title() { # PATTERN [TENTHS OF A SECOND]
    local tenth
    for ((tenth = 0; tenth < ${2-150}; ++tenth)); do
        if found=$(xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -n 1) && [[ -n $found ]]; then
            xdotool windowfocus "$found" 2>/dev/null
            return 0
        fi
        sleep 0.1
    done
    echo "no window has the title $1"
    return 1
}

end_window() {
    wine taskkill /f /im sparkout.exe >/dev/null 2>&1
    local tenth
    for ((tenth = 0; tenth < 50; ++tenth)); do
        xdotool search --onlyvisible --name Sparkout >/dev/null 2>&1 || return 0
        sleep 0.1
    done
}

screen() { # NAME [COLOURS]: what stands on the screen, and whether it is more than an empty window
    sleep 1.5
    import -window root "$pictures/$1.png"
    (($(identify -format %k "$pictures/$1.png") > ${2-300}))
}

forget_window() { # settings and recovery of the Windows of this trial
    rm -rf "$user/Local/sparkout"
}

unpack() {
    python3 -m zipfile -e "$out/$release.zip" "$work/Программы цеха"
    window --version >windows/version.txt 2>&1 && grep -q '^sparkout [0-9.]*' windows/version.txt
}

opens() { # in both languages, with the tour of a first start
    local language
    for language in ru en; do
        forget_window
        start_window "window-$language.txt" --lang "$language"
        await_title Sparkout && screen "window-$language" || return 1
        end_window
        [[ ! -s windows/window-$language.txt ]] || { cat "windows/window-$language.txt"; return 1; }
    done
}

first_paint() { # of the program in Wine's cache, printed
    local begin=${EPOCHREALTIME/./}
    [[ $(window --time-start | tr -d '\r') == painted ]] || return 1
    echo "first painted after $(((${EPOCHREALTIME/./} - begin) / 1000)) ms, with the start of Wine"
}

gallery() { # every example, and every view of one in both languages and of another theme
    local file language view views different
    for file in "${examples[@]}"; do
        picture "example-$(basename "$file" .sparkout)" --lang ru "$file" || return 1
    done
    views=$(window --picture none.png --view none "${examples[0]}" 2>&1 | tr -d '\r' | sed -nE 's/.*known: //p')
    [[ -n $views ]] || return 1
    file=$root/resources/examples/shaft-30h6-factory.sparkout
    for view in ${views//,/}; do
        picture "view-$view-ru" --lang ru --view "$view" "$file" || return 1
        picture "view-$view-en" --lang en --theme dark --font-size 115 --size 1920x1080 --view "$view" "$file" \
            || return 1
    done
    different=$(sha256sum "$pictures"/view-*.png | cut -d ' ' -f 1 | sort -u | wc -l)
    echo "$(find "$pictures" -name 'example-*' | wc -l) examples, $different different pictures of views"
    ((different == $(find "$pictures" -name 'view-*' | wc -l)))
}

picture() { # NAME WORDS…
    local file=$pictures/$1.png
    shift
    window --picture "$file" "$@" 2>windows/picture.txt && [[ ! -s windows/picture.txt ]] \
        && (($(identify -format %k "$file") > 100)) && return
    echo "no picture: $file"
    cat windows/picture.txt
    return 1
}

reports() { # the card's words, and the workbook's sheets, are those of Linux
    local file=$root/resources/examples/shaft-30h6-factory.sparkout language system
    for language in ru en; do
        window --lang "$language" --report card -o "windows/Карта $language.pdf" "$file" || return 1
        QT_QPA_PLATFORM=offscreen "$window_linux" --lang "$language" --report card \
            -o "linux/Карта $language.pdf" "$file" || return 1
        window --lang "$language" --export all -o "windows/Книга $language.xlsx" "$file" || return 1
        QT_QPA_PLATFORM=offscreen "$window_linux" --lang "$language" --export all \
            -o "linux/Книга $language.xlsx" "$file" || return 1
        for system in linux windows; do
            pdftotext "$system/Карта $language.pdf" - | tr -s ' \f\n' '\n' | sort >"$system/card-$language.txt"
            rm -rf "$system/book"
            python3 -m zipfile -e "$system/Книга $language.xlsx" "$system/book"
            sed -i 's|<dcterms:created.*</dcterms:created>||' "$system/book/docProps/core.xml"
        done
        [[ -s windows/card-$language.txt ]] && diff "linux/card-$language.txt" "windows/card-$language.txt" \
            && diff -r linux/book windows/book || return 1
        pdftoppm -r 80 -png "windows/Карта $language.pdf" "$pictures/card-$language"
    done
    pdffonts "windows/Карта ru.pdf" | sed 's/^/    /'
}

# A surface is added by the keyboard, the file is saved and opened again; its name is Cyrillic.
saves() {
    local file="$work/Детали цеха/Вал ступенчатый № 7.sparkout" before
    mkdir -p "$work/Детали цеха"
    cp "$root/resources/examples/shaft-30h6-factory.sparkout" "$file"
    before=$(sha256sum <"$file")
    start_window "save.txt" --lang ru "$file"
    await_title 'Вал ступенчатый' || return 1
    sleep 1
    add_surface 'Вал ступенчатый' || return 1
    xdotool key ctrl+s
    sleep 2
    screen saved || return 1
    end_window
    [[ $(sha256sum <"$file") != "$before" ]] || { echo "the file was not saved"; return 1; }
    [[ ! -s windows/save.txt ]] || { cat windows/save.txt; return 1; }
    windows simulate --json "$file" >windows/saved.json && "$linux" simulate --json "$file" >linux/saved.json \
        && cmp linux/saved.json windows/saved.json || return 1
    start_window "save.txt" --lang ru "$file"
    await_title 'Вал ступенчатый' && screen reopened || return 1
    end_window
}

add_surface() { # by its dialog; the window is known by a part of its title
    xdotool key Escape
    sleep 0.5
    xdotool key ctrl+shift+a
    await_title 'поверхности' 50 || return 1
    sleep 0.5
    xdotool key Return
    sleep 1
    await_title "$1"
    sleep 0.5
}

# The program is ended with unsaved work; the next start offers it.
recovers() {
    forget_window
    mkdir -p "$work/Детали цеха" # a lock stands beside a file that is open
    cp "$root/resources/examples/shaft-38-74h6.sparkout" "$work/Детали цеха/Вал.sparkout"
    start_window "recovery.txt" --lang ru "$work/Детали цеха/Вал.sparkout"
    await_title Sparkout || return 1
    sleep 1
    add_surface Sparkout || return 1
    sleep 4 # it is kept two seconds after the change
    end_window
    [[ -n $(find "$user/Local/sparkout" -name '*.recovery') ]] \
        || { echo "nothing was kept"; return 1; }
    start_window "recovery.txt" --lang ru
    await_title 'Восстановление' && screen recovery-offered || return 1
    xdotool key Return
    sleep 2
    screen recovered
    end_window
    [[ ! -s windows/recovery.txt ]] || { cat windows/recovery.txt; return 1; }
}

registry() { # KEY: what the registry of this Windows has of it
    wine reg query "$1" /s 2>/dev/null | tr -d '\r' | grep -E '^HKEY_|REG_'
}

# Silently, for this user; a file's kind starts the program; nothing stays but the settings.
installs() {
    local into="$user/Local/Programs/Sparkout" ending each left command
    local menu="$user/Roaming/Microsoft/Windows/Start Menu/Programs"
    wine "$out/$release-setup.exe" /S || return 1
    diff -r "$place" "$into" | grep -v 'uninstall\.exe$' && { echo "other files than the zip has"; return 1; }
    [[ -e $menu/Sparkout.lnk && -e $into/uninstall.exe ]] || { echo "no shortcut"; return 1; }
    for ending in Project Pack Lesson Work; do
        registry "HKCU\\Software\\Classes\\Sparkout.$ending\\shell\\open\\command" | grep -q 'sparkout.exe' \
            || { echo "no association of $ending"; return 1; }
    done
    registry 'HKCU\Software\Microsoft\Windows\CurrentVersion\Uninstall\Sparkout' | grep -q QuietUninstall || return 1
    cp "$root/resources/examples/shaft-38-74h6.sparkout" "$work/Детали цеха/Двойной щелчок.sparkout"
    # Wine 8 does not ask the user's own kinds of files, as Windows does: their command is given to it.
    command=$(registry 'HKCU\Software\Classes\Sparkout.Project\shell\open\command' | sed -nE 's/.*REG_SZ +"(.*)" "%1"$/\1/p')
    forget_window
    (exec wine "$command" "$(winepath -w "$work/Детали цеха/Двойной щелчок.sparkout")" >/dev/null 2>&1) &
    disown
    await_title 'Двойной щелчок' && screen double-click || return 1
    end_window
    wine "$into/uninstall.exe" /S
    for each in {1..100}; do # it goes on in a copy of itself
        [[ -e $into ]] || break
        sleep 0.1
    done
    left=$(find "$into" "$menu/Sparkout.lnk" 2>/dev/null)
    for each in .sparkout .sparkout-pack .sparkout-lesson .sparkout-work Sparkout.Project Sparkout.Pack \
        Sparkout.Lesson Sparkout.Work; do
        left+=$(registry "HKCU\\Software\\Classes\\$each")
    done
    left+=$(registry 'HKCU\Software\Microsoft\Windows\CurrentVersion\Uninstall\Sparkout')
    left+=$(registry 'HKCU\Software\Sparkout')
    [[ -z $left ]] || { echo "left behind: $left"; return 1; }
}

# The pages that a user sees.
installer_shown() {
    (exec wine "$out/$release-setup.exe") &
    disown
    await_title 'Sparkout' 400 && screen installer 30 || return 1
    wine taskkill /f /im "$release-setup.exe" >/dev/null 2>&1
    true
}

mkdir -p "$pictures"
check 'window: the zip unpacked where the path is Cyrillic' unpack
check 'window: opens in Russian and in English' opens
check 'window: first painted' first_paint
check 'window: pictures of all examples and views' gallery
check 'window: card as PDF and workbook are those of Linux' reports
check 'window: saves and opens a file with a Cyrillic name' saves
check 'window: unsaved work is offered after a kill' recovers
check 'installer: shown' installer_shown
check 'installer: installs, opens files, leaves nothing' installs
echo "pictures to be looked at: $pictures"
