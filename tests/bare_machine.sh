#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Proves the two README commands on a bare machine: a fresh Debian 12 without any extra package,
# clones of the current HEAD in it, "./workbench run" and "./workbench test" in each. One clone is in
# the home folder, which nobody else may enter (0700), one in a folder with a space and Cyrillic.
#
#   bare_machine.sh [--user] [--home | --odd] [--long] [--keep]    as root; needs debootstrap, git,
#                                                                  about 8 GB
#     --user   as an ordinary user with sudo and without a terminal, instead of as root
#     --home   the clone in the home folder alone
#     --odd    the clone in the oddly named folder alone
#     --long   "./workbench test --long" instead of "./workbench test"
#     --keep   leaves the tree in place and prints where
#
# The mounts live in a namespace of their own and end with it, so removing the tree is safe.
set -eu -o pipefail

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
odd="/srv/шлифовка вал"
path=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin

say() { printf '\n#### %s\n' "$*"; }

mirror() { # the host's own, whichever way it is written down
    { grep -hE '^deb .*debian' /etc/apt/sources.list /etc/apt/sources.list.d/*.list \
        | grep -oE 'https?://[^ ]+' \
        || grep -hE '^URIs:' /etc/apt/sources.list.d/debian.sources | grep -oE 'https?://[^ ]+'
    } 2>/dev/null | grep -v security | head -n 1 || true
}

home_of() { # USER
    [[ -n $1 ]] && echo "/home/$1" || echo /root
}

make_tree() { # TREE USER PLACE…
    local tree=$1 user=$2 place from=http://deb.debian.org/debian found include=()
    found=$(mirror)
    shift 2
    [[ -z $user ]] || include=('--include=sudo,adduser')
    say "debootstrap --variant=minbase bookworm from ${found:-$from}"
    debootstrap --variant=minbase "${include[@]}" bookworm "$tree" "${found:-$from}" >"$tree.log" 2>&1 \
        || { tail "$tree.log"; return 1; }
    # How this host reaches the network: names, and proxies if there are any.
    cp -L /etc/resolv.conf /etc/hosts "$tree/etc/" 2>/dev/null || true
    grep -lsi proxy /etc/apt/apt.conf.d/* | while read -r file; do
        cp "$file" "$tree/etc/apt/apt.conf.d/"
    done || true
    if [[ -n $user ]]; then
        chroot "$tree" adduser --quiet --disabled-password --gecos '' "$user"
        echo "$user ALL=(ALL) NOPASSWD: ALL" >"$tree/etc/sudoers.d/$user"
    fi
    chmod 700 "$tree$(home_of "$user")"
    for place; do
        git clone -q --no-hardlinks "$root" "$tree$place"
        [[ -z $user ]] || chroot "$tree" chown -R "$user" "$place"
    done
}

inside() { # TREE USER TEST PLACE…: in the namespace
    local tree=$1 user=$2 test=$3 place command result=0 begin
    local -a enter=(chroot "$tree" env -i PATH="$path" HOME=/root)
    [[ -z $user ]] || enter=(chroot --userspec="$user:$user" "$tree" env -i PATH="$path"
        HOME="/home/$user" USER="$user")
    shift 3
    mount --bind "$tree" "$tree" # its root is a mount point, as on a machine
    mount -t proc proc "$tree/proc" || echo "no /proc: going on without"
    mount -t tmpfs -o mode=1777 shm "$tree/dev/shm" || true
    for place; do
        for command in run "$test"; do
            say "$place/workbench $command, as ${user:-root}"
            begin=$SECONDS
            # From another working directory and without a terminal.
            # shellcheck disable=SC2086 # words
            "${enter[@]}" "$place/workbench" $command </dev/null || result=1
            say "$place/workbench $command took $((SECONDS - begin)) s, status $result so far"
        done
        du -sh "$tree$place"
    done
    df -h "$tree" | tail -n 1
    return $result
}

if [[ ${1-} == --inside ]]; then
    inside "${@:2}"
    exit
fi

user="" keep="" only="" test=test
for argument; do
    case $argument in
        --user) user=builder ;;
        --keep) keep=1 ;;
        --long) test="test --long" ;;
        --home | --odd) only=${argument#--} ;;
        *) sed -n '3,16s/^# \{0,1\}//p' "$0"; exit 2 ;;
    esac
done
((EUID == 0)) || { echo "bare_machine.sh must run as root (debootstrap, chroot)" >&2; exit 2; }
places=("$(home_of "$user")/sparkout" "$odd")
[[ $only != home ]] || places=("${places[0]}")
[[ $only != odd ]] || places=("$odd")
work=$(mktemp -d "${TMPDIR:-/var/tmp}/sparkout-bare-XXXXXX")
chmod 755 "$work"
# shellcheck disable=SC2317 # called by the trap
cleanup() {
    if [[ -n $keep ]]; then
        echo "the tree is $work/tree"
    elif grep -qF " $work/" /proc/self/mounts; then
        echo "something is still mounted below $work: not removed" >&2
    else
        rm -rf --one-file-system "$work"
    fi
}
trap cleanup EXIT
begin=$SECONDS
make_tree "$work/tree" "$user" "${places[@]}"
say "the bare tree took $((SECONDS - begin)) s, $(du -sh "$work/tree" | cut -f 1)"
result=0
unshare --mount --pid --fork --kill-child --propagation private "$0" --inside "$work/tree" "$user" \
    "$test" "${places[@]}" || result=$?
say "$( ((result)) && echo FAIL || echo PASS), $((SECONDS - begin)) s in all"
exit $result
