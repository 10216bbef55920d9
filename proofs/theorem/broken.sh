#!/usr/bin/env bash
# Shows that the check can fail: each of these changes of the kernel, made in a copy of the tree, breaks the tie.
#
#   bash proofs/theorem/broken.sh          all of them
#   bash proofs/theorem/broken.sh 3 7      the third and the seventh
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

# file @ what stands there @ what takes its place
changes=(
    'fence@norm(position).le(radius)@norm(position).length.lt(radius.mul(norm(position).scale))'
    'fence@x.add(u.mul(time_s))@x.sub(u.mul(time_s))'
    'fence@            place = end;@'
    'fence@kept < plan.steps()@kept < plan.steps().min(8)'
    'fence@if dt_ms.lt(rest) { dt_ms } else { rest }@dt_ms'
    'deadline@60_000.0@600_000.0'
    'deadline@age_ms(now_s, received_s).le(ttl_ms)@age_ms(now_s, received_s).lt(ttl_ms)'
    'speed@vector.len() as f64 + 8.0@vector.len() as f64 + 9.0'
    'speed@bound.mul(self.scale)@bound'
    'speed@S::constant(LARGE), S::constant(1.0)@S::constant(LARGE), S::constant(UP)'
    'plant@tick > steps@tick > steps + 1'
    'plant@.should_hold(now_s) || self.estop@.should_hold(now_s)'
    'watchdog@    deadline: Option<(S, S)>,@    deadline: Option<(S, S)>, pub commands: u8,'
    'gates@Some((position, radius_m))@None'
)

mkdir -p "$copy/spec" "$copy/proofs"
cp -r "$root/spec/kernel" "$copy/spec/kernel"
cp -r "$here" "$copy/proofs/theorem"
cp "$root/Cargo.lock" "$copy"
perl -0pe 's/^members = \[.*?\]/members = ["spec\/kernel", "proofs\/theorem"]/ms' "$root/Cargo.toml" >"$copy/Cargo.toml"

# What says no to every copy says nothing of a change.
if ! said=$(CARGO_TARGET_DIR="$copy/target" bash "$copy/proofs/theorem/check.sh" --tie 2>&1); then
    echo "the copy is refused without a change:" >&2
    tail -n 20 <<<"$said" >&2
    exit 1
fi
echo "unchanged: $(tail -n 1 <<<"$said")"

broken=0
for nth in "${@:-$(seq ${#changes[@]})}"; do
    for number in $nth; do
        change=${changes[number - 1]}
        file=${change%%@*} rest=${change#*@}
        from=${rest%%@*} to=${rest#*@}
        source="$copy/spec/kernel/src/decisions/$file.rs"
        cp "$root/spec/kernel/src/decisions/$file.rs" "$source"
        FROM=$from TO=$to perl -0pi -e 's/\Q$ENV{FROM}\E/$ENV{TO}/' "$source"
        # A new field needs its values.
        if [ "$file" = watchdog ]; then perl -pi -e 's/deadline: None \}/deadline: None, commands: 0 }/' "$source"; fi
        if cmp -s "$root/spec/kernel/src/decisions/$file.rs" "$source"; then
            echo "change $number finds nothing to change in $file.rs" >&2
            exit 1
        fi
        if said=$(CARGO_TARGET_DIR="$copy/target" bash "$copy/proofs/theorem/check.sh" --tie 2>&1); then
            echo "change $number of $file.rs is not noticed: $from -> $to" >&2
            exit 1
        fi
        case $said in
            *'error[E'* | *'could not compile'* | *'failed to parse manifest'*)
                echo "change $number of $file.rs does not compile" >&2
                exit 1
                ;;
        esac
        echo "change $number of $file.rs: $(tail -n 1 <<<"$said")"
        cp "$root/spec/kernel/src/decisions/$file.rs" "$source"
        broken=$((broken + 1))
    done
done
echo "broken: $broken changes, each noticed"
