#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Proves the two README commands on a bare machine: a fresh Debian 12 without any extra package,
# a clone of the current HEAD in it, "./workbench run" and "./workbench test".
#
#   bare_machine.sh [--user] [--keep]      as root; needs debootstrap, git and about 5 GB
#     --user   as an ordinary user with sudo and without a terminal, instead of as root
#     --keep   leaves the tree in place and prints where
#
# The mounts live in a namespace of their own and end with it, so removing the tree is safe.
set -eu -o pipefail

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
path=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin

say() { printf '\n#### %s\n' "$*"; }

mirror() { # the host's own, whichever way it is written down
    { grep -hE '^deb .*debian' /etc/apt/sources.list /etc/apt/sources.list.d/*.list \
        | grep -oE 'https?://[^ ]+' \
        || grep -hE '^URIs:' /etc/apt/sources.list.d/debian.sources | grep -oE 'https?://[^ ]+'
    } 2>/dev/null | grep -v security | head -n 1 || true
}

make_tree() { # TREE USER
    local tree=$1 from=http://deb.debian.org/debian found include=()
    found=$(mirror)
    [[ -z $2 ]] || include=('--include=sudo,adduser')
    say "debootstrap --variant=minbase bookworm from ${found:-$from}"
    debootstrap --variant=minbase "${include[@]}" bookworm "$tree" "${found:-$from}" >"$tree.log" 2>&1 \
        || { tail "$tree.log"; return 1; }
    # How this host reaches the network: names, and proxies if there are any.
    cp -L /etc/resolv.conf /etc/hosts "$tree/etc/" 2>/dev/null || true
    grep -lsi proxy /etc/apt/apt.conf.d/* | while read -r file; do
        cp "$file" "$tree/etc/apt/apt.conf.d/"
    done || true
    # A folder with a space: the scripts must cope.
    git clone -q --no-hardlinks "$root" "$tree/srv/sparkout clone"
    if [[ -n $2 ]]; then
        chroot "$tree" adduser --quiet --disabled-password --gecos '' "$2"
        echo "$2 ALL=(ALL) NOPASSWD: ALL" >"$tree/etc/sudoers.d/$2"
        chroot "$tree" chown -R "$2" "/srv/sparkout clone"
    fi
}

inside() { # TREE USER: in the namespace
    local tree=$1 user=$2 command result=0 begin
    local -a enter=(chroot "$tree" env -i PATH="$path" HOME=/root)
    [[ -z $user ]] || enter=(chroot --userspec="$user:$user" "$tree" env -i PATH="$path"
        HOME="/home/$user" USER="$user")
    mount --bind "$tree" "$tree" # its root is a mount point, as on a machine
    mount -t proc proc "$tree/proc" || echo "no /proc: going on without"
    mount -t tmpfs -o mode=1777 shm "$tree/dev/shm" || true
    for command in run test; do
        say "./workbench $command, as ${user:-root}"
        begin=$SECONDS
        # From another working directory and without a terminal.
        "${enter[@]}" "/srv/sparkout clone/workbench" "$command" </dev/null || result=1
        say "./workbench $command took $((SECONDS - begin)) s, status $result so far"
    done
    df -h "$tree" | tail -n 1
    return $result
}

if [[ ${1-} == --inside ]]; then
    inside "$2" "${3-}"
    exit
fi

user="" keep=""
for argument; do
    case $argument in
        --user) user=builder ;;
        --keep) keep=1 ;;
        *) sed -n '3,11s/^# \{0,1\}//p' "$0"; exit 2 ;;
    esac
done
((EUID == 0)) || { echo "bare_machine.sh must run as root (debootstrap, chroot)" >&2; exit 2; }
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
make_tree "$work/tree" "$user"
say "the bare tree took $((SECONDS - begin)) s, $(du -sh "$work/tree" | cut -f 1)"
result=0
unshare --mount --pid --fork --kill-child --propagation private "$0" --inside "$work/tree" "$user" \
    || result=$?
say "$( ((result)) && echo FAIL || echo PASS), $((SECONDS - begin)) s in all"
exit $result
