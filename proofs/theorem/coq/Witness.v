(** The hypotheses can be met, and the tolerance is needed. *)

From Coq Require Import ZArith Reals Psatz Bool.
From Flocq Require Import Core BinarySingleNaN.
From NCP Require Import Kernel Doubles Ball Inside Step Horizon Clock Motion Governed.

Open Scope R_scope.

(** ** A plant that meets all hypotheses, and moves: 1 m/s for a second, in a fence of 10 m. *)

Definition numbers : Sequence := {| seq := Z; seq_lt := Z.ltb; seq_zero := Z.eqb 0 |}.

Definition order : plan doubles := {|
  plan_mode := Active; ttl_ms := thousand; dt_ms := None; steps := 0; limited := fun _ => Ok false;
  velocity := fun k => match k with O => Some (whole 1, zero, zero) | _ => None end |}.

Definition fenced : gates doubles := {|
  max_speed_mps := Disabled; fence_m := Enabled (whole 10); timeout_ms := thousand; config_fault := false;
  latched := false |}.

Definition origin : vec doubles := (zero, zero, zero).

Definition path (age : R) : point := moved (0, 0, 0) (1, 0, 0) (Rmin age 1000).

Lemma order_passes : govern fenced order zero (Some zero) (Some origin) = (Passed, fenced, 0%nat).
Proof.
  assert (Fresh : is_fresh (zero : num doubles) zero thousand = true) by (vm_compute; reflexivity).
  assert (Inside : inside origin (whole 10) = true) by (vm_compute; reflexivity).
  assert (Ends : steps_inside (truncated order 0) origin (whole 10) = Ok 0%nat) by (vm_compute; reflexivity).
  assert (Limits : limit_ticks order = Ok (false, 0%nat)) by reflexivity.
  unfold govern. change (plan_mode order) with Active. cbv iota zeta.
  change (latched fenced) with false. change (config_fault fenced) with false. change (timeout_ms fenced) with (thousand : num doubles).
  change (fence_m fenced) with (Enabled (whole 10 : num doubles)). rewrite Fresh, Inside, Limits. cbv iota beta delta [negb].
  rewrite Ends. reflexivity.
Qed.

Lemma order_plays : plays (Q := numbers) (truncated order 0) zero 1%Z zero = Some 0%nat.
Proof. vm_compute. reflexivity. Qed.

Lemma order_velocity : velocity_of order 0 = (1, 0, 0).
Proof.
  unfold velocity_of, order, velocity, place. destruct zero_val as (_ & ->).
  destruct (whole_val 1 ltac:(simpl; lia)) as (_ & ->). reflexivity.
Qed.

Lemma some_plant_follows :
  following (Q := numbers) (truncated order 0) origin zero 1%Z 1 1000 (fun _ => zero) path 1000.
Proof.
  assert (Z : val (zero : num doubles) = 0) by apply zero_val.
  constructor.
  - unfold path, place, origin. rewrite Z, Rmin_left by lra. simpl. f_equal; [f_equal|]; lra.
  - intros age H. unfold exact_age. rewrite Z. rewrite Rmult_minus_distr_r, Rmult_0_l. apply Rabs_le. lra.
  - lra.
  - intros age _. rewrite order_plays. discriminate.
  - intros age H. unfold path. now rewrite !Rmin_right by lra.
  - intros a b k H Hb P. destruct (Req_dec a b) as [->|N]; [now rewrite Rminus_eq_0, moved_0|].
    specialize (P a ltac:(lra)). rewrite order_plays in P. injection P as <-.
    change (velocity_of (truncated order 0) 0) with (velocity_of order 0). rewrite order_velocity.
    unfold path. rewrite !Rmin_left, moved_moved by lra. f_equal. ring.
  - intros a b H Hb. unfold path. rewrite !Rmin_left by lra.
    replace (moved (0, 0, 0) (1, 0, 0) b) with (moved (moved (0, 0, 0) (1, 0, 0) a) (1, 0, 0) (b - a))
      by (rewrite moved_moved; f_equal; ring).
    apply slow_moved; [|lra]. unfold slow, near. rewrite !Rminus_0_r, Rabs_R1, Rabs_R0. lra.
Qed.

(** ** A point that is computed to be inside 10 m and lies outside, by 1.77e-15 m: 1.6 of the 3 parts in 2^53 that the
    theorem allows *)

Lemma dyadic_exact : forall m e, (Z.abs m < 2 ^ 53)%Z -> (-1074 <= e <= 0)%Z ->
  val (dyadic m e) = IZR m * bpow radix2 e.
Proof.
  intros m e Hm He. pose proof (binary_normalize_correct 53 1024 precise bounded mode_NE m e false) as C. cbv zeta in C.
  assert (Fm : generic_format radix2 (SpecFloat.fexp 53 1024) (F2R (Float radix2 m e))).
  { change (SpecFloat.fexp 53 1024) with (FLT_exp (-1074) 53). apply generic_format_FLT.
    exists (Float radix2 m e); simpl; try reflexivity; lia. }
  change (round_mode mode_NE) with ZnearestE in C. rewrite (round_generic _ _ _ _ Fm), Rlt_bool_true in C.
  - destruct C as (C & _). exact C.
  - unfold F2R. cbn [Fnum Fexp]. rewrite Rabs_mult, (Rabs_right (bpow radix2 e)) by (apply Rle_ge, bpow_ge_0).
    apply Rle_lt_trans with (IZR (2 ^ 53) * 1).
    + apply Rmult_le_compat; [apply Rabs_pos|apply bpow_ge_0| |].
      * rewrite <- abs_IZR. apply IZR_le. lia.
      * change 1 with (bpow radix2 0). apply bpow_le. lia.
    + rewrite Rmult_1_r. change (IZR (2 ^ 53)) with (IZR (radix2 ^ 53)). rewrite IZR_Zpower by lia. apply bpow_lt. lia.
Qed.

Definition outlier : vec doubles :=
  (dyadic 3074715136271155 (-49), dyadic 2252717439315827 (-48), dyadic (-5569126884387063) (-51)).

Lemma outlier_inside : inside outlier (whole 10) = true.
Proof. vm_compute. reflexivity. Qed.

Lemma outlier_outside : 10 + 177 / 100 * / 1000000000000000 < far (place outlier).
Proof.
  unfold far. rewrite <- (sqrt_square (10 + 177 / 100 * / 1000000000000000)) by lra. apply sqrt_lt_1_alt. split; [lra|].
  unfold outlier, place, square. rewrite !dyadic_exact by (simpl; lia).
  change (bpow radix2 (-49)) with (/ 562949953421312). change (bpow radix2 (-48)) with (/ 281474976710656).
  change (bpow radix2 (-51)) with (/ 2251799813685248). lra.
Qed.
