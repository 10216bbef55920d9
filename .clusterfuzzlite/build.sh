#!/bin/bash -eu
# Builds every fuzz target, with its corpus and its dictionary, as ClusterFuzzLite and OSS-Fuzz want them:
# they set $SRC, $OUT and the flags of the sanitizer.
cd "$SRC/ncp/fuzz"
cargo fuzz build -O --debug-assertions
release="target/x86_64-unknown-linux-gnu/release"
for wrapper in fuzz_targets/*.rs; do
  target="$(basename "$wrapper" .rs)"
  cp "$release/$target" "$OUT/"
  (cd "corpus/$target" && zip --quiet --recurse-paths "$OUT/${target}_seed_corpus.zip" .)
  printf '[libfuzzer]\nmax_len = 4096\nrss_limit_mb = 2560\n' >"$OUT/$target.options"
  case "$target" in
    frame_* | validate_* | session | peer_*)
      cp dict/frame.dict "$OUT/$target.dict"
      echo "dict = $target.dict" >>"$OUT/$target.options"
      ;;
  esac
done
