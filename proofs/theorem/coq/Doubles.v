(** The doubles of IEEE 754 as the kernel's numbers, and what a finite result says of them in real numbers. *)

From Coq Require Import ZArith Reals Psatz Bool.
From Flocq Require Import Core Relative BinarySingleNaN.
From NCP Require Import Kernel.

Open Scope R_scope.

Definition precise : Prec_gt_0 53 := eq_refl.
Definition bounded : Prec_lt_emax 53 1024 := eq_refl.
#[global] Existing Instance precise.
#[global] Existing Instance bounded.

Definition double := binary_float 53 1024.

(** Rounded down to an index, at most [most]: the conversion from a float saturates, and makes 0 of a NaN. *)
Definition double_index (x : double) (most : nat) : nat :=
  match x with
  | B754_infinity false => most
  | B754_infinity true | B754_nan => 0
  | _ => Z.to_nat (Z.min (Btrunc x) (Z.of_nat most))
  end.

Definition doubles : Scalar := {|
  num := double;
  dyadic := fun m e => binary_normalize 53 1024 precise bounded mode_NE m e false;
  not_a_number := B754_nan;
  add := Bplus mode_NE;
  sub := Bminus mode_NE;
  mul := Bmult mode_NE;
  div := Bdiv mode_NE;
  root := Bsqrt mode_NE;
  abs := Babs;
  lt := Bltb;
  le := Bleb;
  finite := is_finite;
  floor_index := double_index |}.

(** The real number that a double stands for. *)
Definition val (x : num doubles) : R := B2R (x : double).

(** Rounding to nearest, ties to even, with gradual underflow and without a largest number. *)
Definition rnd (x : R) : R := round radix2 (SpecFloat.fexp 53 1024) ZnearestE x.

(** Half an ulp of 1, and half the smallest double. *)
Definition u : R := bpow radix2 (-53).
Definition tiny : R := bpow radix2 (-1075).

#[global] Instance valid_fexp : Valid_exp (SpecFloat.fexp 53 1024) := FLT_exp_valid (-1074) 53.

Lemma u_pos : 0 < u. Proof. apply bpow_gt_0. Qed.
Lemma tiny_pos : 0 < tiny. Proof. apply bpow_gt_0. Qed.

Lemma u_value : u = / 9007199254740992.
Proof. unfold u. simpl. reflexivity. Qed.

Lemma tiny_below : tiny <= bpow radix2 (-1000).
Proof. apply bpow_le. lia. Qed.

Lemma rnd_error : forall x, Rabs (rnd x - x) <= u * Rabs x + tiny.
Proof.
  intros x. unfold rnd.
  destruct (error_N_FLT radix2 (-1074) 53 eq_refl (fun z => negb (Z.even z)) x) as (e & d & He & Hd & _ & H).
  change (SpecFloat.fexp 53 1024) with (FLT_exp (-1074) 53). rewrite H.
  replace (x * (1 + e) + d - x) with (e * x + d) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  assert (E1 : / 2 * bpow radix2 (Z.opp 53 + 1) = u) by (unfold u; simpl; lra).
  assert (E2 : / 2 * bpow radix2 (-1074) = tiny).
  { unfold tiny. change (/ 2) with (bpow radix2 (-1)). rewrite <- bpow_plus. reflexivity. }
  rewrite E1 in He. rewrite E2 in Hd.
  pose proof (Rabs_pos x). apply Rplus_le_compat; [|exact Hd].
  apply Rmult_le_compat_r; assumption.
Qed.

Lemma rnd_le : forall x y, x <= y -> rnd x <= rnd y.
Proof. intros. apply round_le; auto with typeclass_instances. Qed.

Lemma rnd_0 : rnd 0 = 0.
Proof. apply round_0; auto with typeclass_instances. Qed.

Lemma rnd_nonneg : forall x, 0 <= x -> 0 <= rnd x.
Proof. intros x H. rewrite <- rnd_0. now apply rnd_le. Qed.

Lemma rnd_val : forall x, rnd (val x) = val x.
Proof. intros x. apply round_generic; auto with typeclass_instances. apply generic_format_B2R. Qed.

Lemma rnd_rnd : forall x, rnd (rnd x) = rnd x.
Proof. intros x. apply round_generic; auto with typeclass_instances. apply generic_format_round; auto with typeclass_instances. Qed.

(** ** What a finite result says *)

Lemma overflow_not_finite : forall (x : double) s, B2SF x = binary_overflow 53 1024 mode_NE s -> is_finite x = false.
Proof. intros x s H. rewrite <- is_finite_SF_B2SF, H. reflexivity. Qed.

Lemma add_finite : forall x y : num doubles, finite (add x y) = true ->
  finite x = true /\ finite y = true /\ val (add x y) = rnd (val x + val y).
Proof.
  intros x y. simpl. intros H.
  destruct (is_finite (x : double)) eqn:Hx; [destruct (is_finite (y : double)) eqn:Hy|].
  - split; [reflexivity|split; [reflexivity|]].
    pose proof (Bplus_correct 53 1024 precise bounded mode_NE x y Hx Hy) as C.
    destruct Rlt_bool; [now destruct C as (C & _)|].
    destruct C as (C & _). apply overflow_not_finite in C. unfold double in *. simpl in *. congruence.
  - exfalso. destruct x as [[]|[]| |[]]; destruct y as [[]|[]| |[]]; simpl in *; discriminate.
  - exfalso. destruct x as [[]|[]| |[]]; destruct y as [[]|[]| |[]]; simpl in *; discriminate.
Qed.

Lemma sub_finite : forall x y : num doubles, finite (sub x y) = true ->
  finite x = true /\ finite y = true /\ val (sub x y) = rnd (val x - val y).
Proof.
  intros x y. simpl. intros H.
  destruct (is_finite (x : double)) eqn:Hx; [destruct (is_finite (y : double)) eqn:Hy|].
  - split; [reflexivity|split; [reflexivity|]].
    pose proof (Bminus_correct 53 1024 precise bounded mode_NE x y Hx Hy) as C.
    destruct Rlt_bool; [now destruct C as (C & _)|].
    destruct C as (C & _). apply overflow_not_finite in C. unfold double in *. simpl in *. congruence.
  - exfalso. destruct x as [[]|[]| |[]]; destruct y as [[]|[]| |[]]; simpl in *; discriminate.
  - exfalso. destruct x as [[]|[]| |[]]; destruct y as [[]|[]| |[]]; simpl in *; discriminate.
Qed.

Lemma mul_finite : forall x y : num doubles, finite (mul x y) = true ->
  finite x = true /\ finite y = true /\ val (mul x y) = rnd (val x * val y).
Proof.
  intros x y. simpl. intros H.
  pose proof (Bmult_correct 53 1024 precise bounded mode_NE x y) as C.
  destruct Rlt_bool.
  - destruct C as (C & D & _). unfold double in *. rewrite D in H. apply andb_prop in H. tauto.
  - apply overflow_not_finite in C. unfold double in *. simpl in *. congruence.
Qed.

(** A quotient may be finite though the divisor is infinite; so the divisor is asked for. *)
Lemma div_finite : forall x y : num doubles, finite (div x y) = true -> val y <> 0 ->
  finite x = true /\ val (div x y) = rnd (val x / val y).
Proof.
  intros x y. simpl. intros H Hy.
  pose proof (Bdiv_correct 53 1024 precise bounded mode_NE x y Hy) as C.
  destruct Rlt_bool.
  - destruct C as (C & D & _). unfold double in *. rewrite D in H. tauto.
  - apply overflow_not_finite in C. unfold double in *. simpl in *. congruence.
Qed.

Lemma root_finite : forall x : num doubles, finite (root x) = true ->
  finite x = true /\ val (root x) = rnd (sqrt (val x)).
Proof.
  intros x. simpl. intros H.
  destruct (Bsqrt_correct 53 1024 precise bounded mode_NE x) as (C & D & _).
  split; [|exact C]. unfold double in *. rewrite D in H. destruct x as [| | |[]]; auto; discriminate.
Qed.

Lemma le_val : forall x y : num doubles, finite x = true -> finite y = true -> le x y = true -> val x <= val y.
Proof.
  intros x y Hx Hy H. simpl in *. unfold double in *. rewrite Bleb_correct in H by assumption.
  destruct (Rle_bool_spec (B2R x) (B2R y)); [assumption|discriminate].
Qed.

Lemma val_le : forall x y : num doubles, finite x = true -> finite y = true -> val x <= val y -> le x y = true.
Proof.
  intros x y Hx Hy H. simpl in *. unfold double in *. rewrite Bleb_correct by assumption. now apply Rle_bool_true.
Qed.

Lemma not_le_val : forall x y : num doubles, finite x = true -> finite y = true -> le x y = false -> val y < val x.
Proof.
  intros x y Hx Hy H. simpl in *. unfold double in *. rewrite Bleb_correct in H by assumption.
  destruct (Rle_bool_spec (B2R x) (B2R y)); [discriminate|assumption].
Qed.

Lemma lt_val : forall x y : num doubles, finite x = true -> finite y = true -> lt x y = true -> val x < val y.
Proof.
  intros x y Hx Hy H. simpl in *. unfold double in *. rewrite Bltb_correct in H by assumption.
  destruct (Rlt_bool_spec (B2R x) (B2R y)); [assumption|discriminate].
Qed.

Lemma not_lt_val : forall x y : num doubles, finite x = true -> finite y = true -> lt x y = false -> val y <= val x.
Proof.
  intros x y Hx Hy H. simpl in *. unfold double in *. rewrite Bltb_correct in H by assumption.
  destruct (Rlt_bool_spec (B2R x) (B2R y)); [discriminate|assumption].
Qed.

(** What is not above a finite number, and is not below another, is finite. *)
Lemma le_finite : forall x y : num doubles, le x y = true -> finite y = true -> le zero x = true -> finite x = true.
Proof. intros x y. simpl. destruct x as [[]|[]| |[]]; destruct y as [[]|[]| |[]]; simpl; try discriminate; auto. Qed.

(** ** Whole numbers *)

Lemma whole_exact : forall m : Z, (Z.abs m <= 2 ^ 53)%Z ->
  finite (dyadic m 0 : num doubles) = true /\ val (dyadic m 0) = IZR m.
Proof.
  intros m Hm.
  assert (F : generic_format radix2 (SpecFloat.fexp 53 1024) (IZR m)).
  { replace (IZR m) with (F2R (Float radix2 m 0)) by (unfold F2R; simpl; ring).
    destruct (Z.eq_dec (Z.abs m) (2 ^ 53)) as [E|E].
    - assert (C : m = (2 ^ 53)%Z \/ m = (- 2 ^ 53)%Z) by lia.
      assert (G : generic_format radix2 (SpecFloat.fexp 53 1024) (bpow radix2 53)).
      { change (SpecFloat.fexp 53 1024) with (FLT_exp (-1074) 53). apply generic_format_bpow. unfold FLT_exp. lia. }
      assert (B : F2R (Float radix2 (2 ^ 53) 0) = bpow radix2 53) by (unfold F2R; simpl; ring).
      destruct C as [-> | ->].
      + now rewrite B.
      + change (- 2 ^ 53)%Z with (Z.opp (2 ^ 53)). rewrite F2R_Zopp, B. now apply generic_format_opp.
    - change (SpecFloat.fexp 53 1024) with (FLT_exp (-1074) 53). apply generic_format_FLT.
      exists (Float radix2 m 0); simpl; try reflexivity; lia. }
  pose proof (binary_normalize_correct 53 1024 precise bounded mode_NE m 0 false) as C.
  cbv zeta in C.
  assert (E : F2R (Float radix2 m 0) = IZR m) by (unfold F2R; simpl; ring).
  rewrite E in C. simpl round_mode in C.
  rewrite (round_generic radix2 (SpecFloat.fexp 53 1024) ZnearestE (IZR m) F) in C.
  rewrite Rlt_bool_true in C.
  - destruct C as (C & D & _). split; [exact D|exact C].
  - rewrite <- abs_IZR. apply Rle_lt_trans with (IZR (2 ^ 53)).
    + now apply IZR_le.
    + change (IZR (2 ^ 53)) with (IZR (radix2 ^ 53)). rewrite IZR_Zpower by lia. apply bpow_lt. lia.
Qed.

Lemma zero_val : finite (zero : num doubles) = true /\ val zero = 0.
Proof. apply (whole_exact 0). lia. Qed.

Lemma thousand_val : finite (thousand : num doubles) = true /\ val thousand = 1000.
Proof. apply (whole_exact 1000). lia. Qed.

Lemma max_ttl_val : finite (max_ttl_ms : num doubles) = true /\ val max_ttl_ms = 60000.
Proof. apply (whole_exact 60000). lia. Qed.

Lemma whole_val : forall n : nat, (Z.of_nat n <= 2 ^ 53)%Z ->
  finite (whole n : num doubles) = true /\ val (whole n) = INR n.
Proof. intros n Hn. rewrite INR_IZR_INZ. apply whole_exact. lia. Qed.

Lemma rnd_INR : forall n : nat, (Z.of_nat n <= 2 ^ 53)%Z -> rnd (INR n) = INR n.
Proof. intros n Hn. destruct (whole_val n Hn) as (_ & <-). apply rnd_val. Qed.

(** ** Indices *)

Lemma index_finite : forall (x : num doubles) (most : nat), is_finite (x : double) = true ->
  floor_index x most = Z.to_nat (Z.min (Btrunc (x : double)) (Z.of_nat most)).
Proof. intros x most F. destruct x; try discriminate; reflexivity. Qed.

Lemma index_ge : forall (x : num doubles) (k most : nat), (k <= floor_index x most)%nat -> (0 < k)%nat ->
  finite x = false \/ INR k <= val x.
Proof.
  intros x k most H Hk. simpl. destruct (is_finite (x : double)) eqn:F; [right|now left].
  assert (T : (Z.of_nat k <= Btrunc (x : double))%Z).
  { rewrite (index_finite x most F) in H. generalize dependent (Btrunc (x : double)). intros z Hz. lia. }
  apply IZR_le in T. rewrite Btrunc_correct in T by exact bounded. rewrite <- INR_IZR_INZ in T.
  rewrite round_FIX_IZR in T. unfold val.
  destruct (Rle_lt_dec 0 (B2R (x : double))) as [P|P].
  - rewrite Ztrunc_floor in T by exact P. pose proof (Zfloor_lb (B2R (x : double))). lra.
  - rewrite Ztrunc_ceil in T by lra. pose proof (Zceil_glb 0 (B2R (x : double))) as G.
    apply lt_INR in Hk. simpl in Hk.
    assert (IZR (Zceil (B2R (x : double))) <= 0). { apply IZR_le. apply G. simpl. lra. } lra.
Qed.

Lemma index_lt : forall (x : num doubles) (k most : nat), (floor_index x most < k)%nat -> (k <= most)%nat ->
  le zero x = true -> val x < INR k /\ finite x = true.
Proof.
  intros x k most H Hk Hx.
  assert (F : is_finite (x : double) = true).
  { destruct x as [s|[]| |s m e b]; try discriminate; try reflexivity. simpl in H. lia. }
  split; [|exact F].
  assert (P : 0 <= B2R (x : double)).
  { destruct zero_val as (Zf & Z0). pose proof (le_val zero x Zf F Hx) as L. unfold val in *. lra. }
  assert (T : (Btrunc (x : double) < Z.of_nat k)%Z).
  { assert (N : (0 <= Btrunc (x : double))%Z).
    { apply le_IZR. rewrite Btrunc_correct by exact bounded. rewrite round_FIX_IZR, Ztrunc_floor by exact P.
      apply IZR_le. now apply Zfloor_lub. }
    rewrite (index_finite x most F) in H. generalize dependent (Btrunc (x : double)). intros z Hz Hn. lia. }
  assert (L : (Btrunc (x : double) + 1 <= Z.of_nat k)%Z) by lia.
  apply IZR_le in L. rewrite plus_IZR, Btrunc_correct in L by exact bounded. rewrite <- INR_IZR_INZ in L.
  rewrite round_FIX_IZR, Ztrunc_floor in L by exact P. pose proof (Zfloor_ub (B2R (x : double))). unfold val. lra.
Qed.

(** The law of an index that the tie to the source uses. *)
Lemma double_index_bounded : forall (x : num doubles) (most : nat), (floor_index x most <= most)%nat.
Proof.
  intros x most. simpl. destruct x as [s|[]| |s m e b]; simpl; lia.
Qed.
