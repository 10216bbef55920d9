#!/usr/bin/env bash
# Checks the theorem from the command to the plant: the source of the kernel is run on terms, Coq proves that what it does
# is the model, and proves the theorems of the model.
#
#   bash proofs/theorem/check.sh          all of it
#   bash proofs/theorem/check.sh --tie    only that the source is the model
#
# Needs cargo; installs coq, Flocq by apt-get where they are missing, and exits with 3 where that cannot be done. Nothing is
# written beside the target folder.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
work=${CARGO_TARGET_DIR:-$root/target}/theorem
tie=(Kernel Tie Exported)
theory=(Doubles Ball Inside Step Horizon Clock Motion Governed Witness Liveness Theorems)
# The axioms of Coq's classical real numbers, and no other.
allowed='^(ClassicalDedekindReals\.sig_(not_dec|forall_dec)|FunctionalExtensionality\.functional_extensionality_dep|Classical_Prop\.classic)$'

fail() {
    echo "theorem: $*" >&2
    exit 1
}

has_flocq() { [ -e "$(coqc -where)/user-contrib/Flocq/IEEE754/BinarySingleNaN.vo" ]; }

if ! command -v coqc >/dev/null || ! has_flocq; then
    sudo=$([ "$(id -u)" = 0 ] || echo sudo)
    if ! { $sudo apt-get update -q && $sudo apt-get install -y -q --no-install-recommends coq libcoq-flocq; } >&2; then
        echo "theorem: coq and Flocq are not there, and apt-get cannot install them" >&2
        exit 3
    fi
fi
flocq=$(dpkg-query -W -f '${Version}' libcoq-flocq 2>/dev/null || echo unknown)
echo "versions: Coq $(coqc -print-version | cut -d ' ' -f 1), Flocq $flocq"

compile() {
    if ! (cd "$work" && coqc -q -Q . NCP "$1.v") >"$work/$1.log" 2>&1; then
        tail -n 30 "$work/$1.log" >&2
        line=$(sed -n 's/^File .*, line \([0-9]*\),.*/\1/p' "$work/$1.log" | tail -n 1)
        lemma=$(head -n "${line:-1}" "$work/$1.v" | sed -n 's/^\(Lemma\|Theorem\) \([a-zA-Z0-9_]*\).*/\2/p' | tail -n 1)
        fail "$1.v is not proved: ${lemma:-no lemma} (line ${line:-?})"
    fi
}

rm -rf "$work" && mkdir -p "$work"
cp "$here"/coq/*.v "$work"
cargo run --quiet --release --manifest-path "$root/Cargo.toml" -p ncp-theorem -- "$work/Exported.v" ||
    fail "the source does what the export cannot say"

# No gap may stand in the files.
if grep -nwE 'Admitted|admit|give_up|Axioms?|Conjecture|Parameters?|Unset|bypass_check' "$work"/*.v; then
    fail "these words must not stand in a proof"
fi

for file in "${tie[@]}"; do compile "$file"; done
ties=$(grep -c '_is_the_model' "$work/Exported.v")
echo "tie: $ties functions and states of the source are the model's"
[ "${1:-}" != --tie ] || exit 0

for file in "${theory[@]}"; do compile "$file"; done
for file in "$work"/*.v; do
    name=$(basename "$file" .v)
    [[ " ${tie[*]} ${theory[*]} " == *" $name "* ]] || fail "$name.v is not compiled"
done

cat "$work/Theorems.log"
used=$(sed -n '/^Axioms:/,$p' "$work/Theorems.log" | grep -oE '^[A-Za-z_][A-Za-z0-9_.]*' |
    grep -vxE 'Axioms|Closed' | sort -u || true)
echo
echo "axioms, all of Coq's classical real numbers:"
for axiom in $used; do
    [[ $axiom =~ $allowed ]] || fail "an axiom that is not allowed: $axiom"
    echo "  $axiom"
done

asked=$(grep -c '^Print Assumptions' "$work/Theorems.v")
answered=$(grep -cE '^(Axioms:|Closed under the global context)' "$work/Theorems.log")
[ "$asked" = "$answered" ] || fail "$answered of $asked theorems say what they rest on"
stated=$(cat "$work"/*.v | grep -cE '^(Lemma|Theorem) ')
proved=$(cat "$work"/*.v | grep -oE '\bQed\.' | wc -l)
[ "$stated" = "$proved" ] || fail "$stated statements and $proved proofs"
echo "theorem: $((stated - 2)) lemmas, 2 theorems, 0 admitted"
