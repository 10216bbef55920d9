(** A point that the kernel computes to be inside lies inside in exact arithmetic, but for the roundings. *)

From Coq Require Import ZArith Reals Psatz Bool.
From Flocq Require Import Core BinarySingleNaN Mult_error.
From NCP Require Import Kernel Doubles Ball.

Open Scope R_scope.

(** The point of space that three doubles stand for. *)
Definition place (p : vec doubles) : point := let '(x, y, z) := p in (val x, val y, val z).

(** What the underflow of squares may add, in m: 4.4e-162. *)
Definition delta : R := bpow radix2 (-536).

Lemma delta_pos : 0 < delta. Proof. apply bpow_gt_0. Qed.

Lemma delta_square : delta * delta = 8 * tiny.
Proof. unfold delta, tiny. rewrite <- bpow_plus. change 8 with (bpow radix2 3). rewrite <- bpow_plus. reflexivity. Qed.

Lemma tiny_delta : 2 * tiny <= delta.
Proof. unfold delta, tiny. change 2 with (bpow radix2 1). rewrite <- bpow_plus. apply bpow_le. lia. Qed.

Lemma root_below : forall s r : num doubles, finite r = true -> le (root s) r = true -> finite (root s) = true.
Proof.
  intros s r Hr H. simpl in *.
  destruct (Bsqrt_correct 53 1024 precise bounded mode_NE s) as (_ & D & _). unfold double in *. rewrite D.
  destruct s as [|[]| |[]]; try reflexivity; exfalso; simpl in H; destruct r as [|[]| |[]]; discriminate.
Qed.

(** What a computed root of a sum of squares says, in real numbers. *)
Lemma root_finite_exact : forall p : vec doubles, finite (root (squares p)) = true ->
  let '(x, y, z) := place p in
  val (root (squares p)) = rnd (sqrt (rnd (rnd (rnd (x * x) + rnd (y * y)) + rnd (z * z)))).
Proof.
  intros ((x, y), z) H. unfold squares in *. unfold place.
  apply root_finite in H as (H & ->).
  apply add_finite in H as (H & Hz & ->).
  apply add_finite in H as (H & Hy & ->).
  apply add_finite in H as (_ & Hx & ->).
  apply mul_finite in Hx as (_ & _ & ->).
  apply mul_finite in Hy as (_ & _ & ->).
  apply mul_finite in Hz as (_ & _ & ->).
  destruct zero_val as (_ & ->). now rewrite Rplus_0_l, rnd_rnd.
Qed.

Lemma squares_finite : forall x y z : num doubles, finite (squares (x, y, z)) = true ->
  finite x = true /\ finite y = true /\ finite z = true.
Proof.
  intros x y z H. unfold squares in H.
  apply add_finite in H as (H & Hz & _). apply add_finite in H as (H & Hy & _). apply add_finite in H as (_ & Hx & _).
  apply mul_finite in Hx as (Hx & _). apply mul_finite in Hy as (Hy & _). apply mul_finite in Hz as (Hz & _). tauto.
Qed.

Lemma rnd_lower : forall x, 0 <= x -> x * (1 - u) - tiny <= rnd x.
Proof.
  intros x H. pose proof (rnd_error x) as E. rewrite (Rabs_right x) in E by lra. apply Rabs_le_inv in E. lra.
Qed.

Lemma u_small : 0 < u <= / 1000.
Proof. rewrite u_value. lra. Qed.

Lemma relative_square : 1 <= (1 - u) ^ 5 * ((1 + 11 / 4 * u) * (1 + 11 / 4 * u)).
Proof.
  pose proof u_small as H. set (e := u) in *. clearbody e.
  assert (B : 1 - 5 * e <= (1 - e) ^ 5).
  { assert (S : 1 - 2 * e <= (1 - e) * (1 - e)) by nra.
    assert (T : (1 - 2 * e) * (1 - 2 * e) <= (1 - e) * (1 - e) * ((1 - e) * (1 - e))) by nra.
    assert (U : 1 - 4 * e <= (1 - e) * (1 - e) * ((1 - e) * (1 - e))) by nra.
    replace ((1 - e) ^ 5) with ((1 - e) * (1 - e) * ((1 - e) * (1 - e)) * (1 - e)) by ring. nra. }
  assert (0 <= (1 + 11 / 4 * e) * (1 + 11 / 4 * e)) by nra.
  apply Rle_trans with ((1 - 5 * e) * ((1 + 11 / 4 * e) * (1 + 11 / 4 * e))); [nra|].
  now apply Rmult_le_compat_r.
Qed.

Lemma norm_exact : forall x y z r,
  rnd (sqrt (rnd (rnd (rnd (x * x) + rnd (y * y)) + rnd (z * z)))) <= r ->
  far (x, y, z) <= r * (1 + 11 / 4 * u) + delta.
Proof.
  intros x y z r H.
  pose proof u_small as (U & U'). pose proof tiny_pos as T. pose proof delta_pos as D.
  pose proof delta_square as DD. pose proof tiny_delta as DT.
  set (a := x * x) in *. set (b := y * y) in *. set (c := z * z) in *.
  assert (Pa : 0 <= a) by (unfold a; nra). assert (Pb : 0 <= b) by (unfold b; nra).
  assert (Pc : 0 <= c) by (unfold c; nra).
  set (s := rnd (rnd (rnd a + rnd b) + rnd c)) in *.
  assert (S : (a + b + c) * (1 - u) ^ 3 - 5 * tiny <= s).
  { pose proof (rnd_nonneg a Pa). pose proof (rnd_nonneg b Pb). pose proof (rnd_nonneg c Pc).
    pose proof (rnd_lower a Pa). pose proof (rnd_lower b Pb). pose proof (rnd_lower c Pc).
    assert (P2 : 0 <= rnd a + rnd b) by lra. pose proof (rnd_lower _ P2). pose proof (rnd_nonneg _ P2).
    assert (P3 : 0 <= rnd (rnd a + rnd b) + rnd c) by lra. pose proof (rnd_lower _ P3) as L3. fold s in L3.
    set (w := 1 - u) in *. assert (W : 0 <= w <= 1) by (unfold w; lra).
    assert (E2 : (a + b) * (w * w) - 3 * tiny <= rnd (rnd a + rnd b)) by nra.
    assert (E3 : (a + b) * (w * w) - 3 * tiny + c * w - tiny <= rnd (rnd a + rnd b) + rnd c) by lra.
    assert (E4 : ((a + b) * (w * w) - 3 * tiny + c * w - tiny) * w - tiny <= s) by nra.
    assert (E5 : c * (w * w * w) <= c * (w * w)).
    { apply Rmult_le_compat_l; [lra|]. assert (0 <= w * w) by nra. nra. }
    simpl. nra. }
  assert (Ps : 0 <= s).
  { apply rnd_nonneg. apply Rplus_le_le_0_compat; apply rnd_nonneg; [|lra].
    apply Rplus_le_le_0_compat; apply rnd_nonneg; lra. }
  set (q := sqrt s) in *. assert (Pq : 0 <= q) by apply sqrt_pos.
  assert (Q : q * q = s) by (apply sqrt_sqrt; lra).
  pose proof (rnd_lower q Pq) as L. pose proof (rnd_nonneg q Pq) as Pr.
  assert (G : q * (1 - u) <= r + tiny) by lra.
  assert (Rr : 0 <= r) by lra.
  apply far_le; [nra|]. simpl. fold a b c.
  (* (a + b + c) (1 - u)^5 <= (r + tiny)^2 + 5 tiny *)
  assert (M : (a + b + c) * (1 - u) ^ 5 <= (r + tiny) * (r + tiny) + 5 * tiny).
  { set (w := 1 - u) in *. assert (W : 0 <= w <= 1) by (unfold w; lra).
    assert (Z1 : (q * w) * (q * w) <= (r + tiny) * (r + tiny)).
    { apply Rmult_le_compat; try assumption; nra. }
    assert (Z2 : (a + b + c) * w ^ 3 <= q * q + 5 * tiny) by lra.
    assert (W2 : 0 <= w * w <= 1) by nra.
    assert (Z3 : (a + b + c) * w ^ 3 * (w * w) <= (q * q + 5 * tiny) * (w * w)) by (apply Rmult_le_compat_r; lra).
    replace ((a + b + c) * w ^ 5) with ((a + b + c) * w ^ 3 * (w * w)) by ring.
    assert (Z4 : 5 * tiny * (w * w) <= 5 * tiny) by nra. nra. }
  pose proof relative_square as K. set (k := 1 + 11 / 4 * u) in *. assert (Hk : 1 <= k <= 2) by (unfold k; lra).
  set (v := (1 - u) ^ 5) in *. set (n := a + b + c) in *. assert (Pn : 0 <= n) by (unfold n; lra).
  assert (N : n <= n * v * (k * k)).
  { rewrite Rmult_assoc. rewrite <- (Rmult_1_r n) at 1. now apply Rmult_le_compat_l. }
  assert (N2 : n * v * (k * k) <= ((r + tiny) * (r + tiny) + 5 * tiny) * (k * k)).
  { apply Rmult_le_compat_r; [nra|assumption]. }
  assert (Ksq : k * k <= 11 / 10) by (unfold k; nra).
  assert (T1 : tiny * tiny <= tiny / 10).
  { assert (tiny <= / 10). { pose proof tiny_below. assert (bpow radix2 (-1000) <= bpow radix2 (-4)) by (apply bpow_le; lia).
    simpl in *. lra. } nra. }
  assert (F1 : (tiny * tiny + 5 * tiny) * (k * k) <= delta * delta) by nra.
  assert (F2 : 2 * r * tiny * (k * k) <= 2 * r * k * delta).
  { assert (tiny * k <= delta) by nra. assert (0 <= r * k) by nra. nra. }
  nra.
Qed.

(** ** Powers of two *)

Lemma power_exact : forall e : Z, (-1074 <= e < 1024)%Z ->
  finite (dyadic 1 e : num doubles) = true /\ val (dyadic 1 e) = bpow radix2 e.
Proof.
  intros e He. pose proof (binary_normalize_correct 53 1024 precise bounded mode_NE 1 e false) as C. cbv zeta in C.
  assert (E : F2R (Float radix2 1 e) = bpow radix2 e) by (unfold F2R, Fnum, Fexp; apply Rmult_1_l).
  assert (G : generic_format radix2 (SpecFloat.fexp 53 1024) (bpow radix2 e)).
  { change (SpecFloat.fexp 53 1024) with (FLT_exp (-1074) 53). apply generic_format_bpow. unfold FLT_exp. lia. }
  rewrite E in C. simpl round_mode in C. rewrite (round_generic radix2 _ ZnearestE _ G) in C. rewrite Rlt_bool_true in C.
  - destruct C as (C & D & _). split; [exact D|exact C].
  - rewrite Rabs_right by (apply Rle_ge, bpow_ge_0). apply bpow_lt. lia.
Qed.

Lemma power_format : forall e : Z, (-1074 <= e)%Z -> generic_format radix2 (SpecFloat.fexp 53 1024) (bpow radix2 e).
Proof.
  intros e He. change (SpecFloat.fexp 53 1024) with (FLT_exp (-1074) 53). apply generic_format_bpow. unfold FLT_exp. lia.
Qed.

Lemma below_power : forall (x : R) (e : Z), (-1074 <= e < 1024)%Z -> Rabs x <= bpow radix2 e ->
  Rabs (rnd x) <= bpow radix2 e /\ Rlt_bool (Rabs (rnd x)) (bpow radix2 1024) = true.
Proof.
  intros x e He B. assert (L : Rabs (rnd x) <= bpow radix2 e).
  { apply abs_round_le_generic; auto with typeclass_instances. apply power_format. lia. }
  split; [exact L|]. apply Rlt_bool_true. apply Rle_lt_trans with (1 := L). apply bpow_lt. lia.
Qed.

(** A product that does not overflow is finite. *)
Lemma mul_bounded : forall (x y : num doubles) (e : Z), (-1074 <= e < 1024)%Z ->
  finite x = true -> finite y = true -> Rabs (val x * val y) <= bpow radix2 e ->
  finite (mul x y) = true /\ val (mul x y) = rnd (val x * val y).
Proof.
  intros x y e He Fx Fy B. destruct (below_power _ e He B) as (_ & L).
  pose proof (Bmult_correct 53 1024 precise bounded mode_NE x y) as C.
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (B2R (x : double) * B2R (y : double)))
    with (rnd (val x * val y)) in C.
  rewrite L in C. destruct C as (C & D & _). split; [|exact C].
  simpl in *. unfold double in *. now rewrite D, Fx, Fy.
Qed.

Lemma add_bounded : forall (x y : num doubles) (e : Z), (-1074 <= e < 1024)%Z ->
  finite x = true -> finite y = true -> Rabs (val x + val y) <= bpow radix2 e ->
  finite (add x y) = true /\ val (add x y) = rnd (val x + val y).
Proof.
  intros x y e He Fx Fy B. destruct (below_power _ e He B) as (_ & L).
  pose proof (Bplus_correct 53 1024 precise bounded mode_NE x y Fx Fy) as C.
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (B2R (x : double) + B2R (y : double)))
    with (rnd (val x + val y)) in C.
  rewrite L in C. destruct C as (C & D & _). split; [exact D|exact C].
Qed.

Lemma power_square : forall e : Z, bpow radix2 e * bpow radix2 e = bpow radix2 (2 * e).
Proof. intros e. rewrite <- bpow_plus. f_equal. lia. Qed.

(** Components that are not huge have a sum of squares that is not. *)
Lemma squares_bounded : forall x y z : num doubles, finite x = true -> finite y = true -> finite z = true ->
  Rabs (val x) <= bpow radix2 404 -> Rabs (val y) <= bpow radix2 404 -> Rabs (val z) <= bpow radix2 404 ->
  finite (squares (x, y, z)) = true /\ val (squares (x, y, z)) <= bpow radix2 810.
Proof.
  intros x y z Fx Fy Fz Bx By Bz.
  assert (Q : forall v : num doubles, finite v = true -> Rabs (val v) <= bpow radix2 404 ->
    finite (mul v v) = true /\ 0 <= val (mul v v) <= bpow radix2 808).
  { intros v Fv Bv. assert (B : Rabs (val v * val v) <= bpow radix2 808).
    { rewrite Rabs_mult. replace (bpow radix2 808) with (bpow radix2 404 * bpow radix2 404) by apply (power_square 404).
      apply Rmult_le_compat; auto using Rabs_pos. }
    destruct (mul_bounded v v 808 ltac:(lia) Fv Fv B) as (F & V). split; [exact F|]. rewrite V.
    destruct (below_power _ 808 ltac:(lia) B) as (L & _).
    assert (P : 0 <= rnd (val v * val v)) by (apply rnd_nonneg; nra). rewrite Rabs_right in L by lra. lra. }
  assert (A : forall (v w : num doubles) (e : Z), (0 <= e < 1023)%Z -> finite v = true -> finite w = true ->
    0 <= val v <= bpow radix2 e -> 0 <= val w <= bpow radix2 e ->
    finite (add v w) = true /\ 0 <= val (add v w) <= bpow radix2 (e + 1)).
  { intros v w e He Fv Fw Hv Hw. assert (T : bpow radix2 (e + 1) = 2 * bpow radix2 e).
    { rewrite bpow_plus, Rmult_comm. reflexivity. }
    assert (B : Rabs (val v + val w) <= bpow radix2 (e + 1)) by (rewrite Rabs_right; lra).
    destruct (add_bounded v w (e + 1) ltac:(lia) Fv Fw B) as (F & V). split; [exact F|]. rewrite V.
    destruct (below_power _ (e + 1) ltac:(lia) B) as (L & _).
    assert (P : 0 <= rnd (val v + val w)) by (apply rnd_nonneg; lra). rewrite Rabs_right in L by lra. lra. }
  destruct (Q x Fx Bx) as (F1 & V1). destruct (Q y Fy By) as (F2 & V2). destruct (Q z Fz Bz) as (F3 & V3).
  destruct zero_val as (F0 & V0). pose proof (bpow_ge_0 radix2 808) as P8.
  assert (M9 : bpow radix2 808 <= bpow radix2 809) by (apply bpow_le; lia).
  assert (M10 : bpow radix2 809 <= bpow radix2 810) by (apply bpow_le; lia).
  unfold squares.
  (* The first sum adds nothing. *)
  assert (B1 : Rabs (val zero + val (mul x x)) <= bpow radix2 808) by (rewrite V0, Rabs_right; lra).
  destruct (add_bounded zero (mul x x) 808 ltac:(lia) F0 F1 B1) as (G1 & W1).
  rewrite V0, Rplus_0_l, rnd_val in W1.
  destruct (A (add zero (mul x x)) (mul y y) 808%Z ltac:(lia) G1 F2) as (G2 & W2); [lra|lra|].
  change (808 + 1)%Z with 809%Z in W2.
  destruct (A (add (add zero (mul x x)) (mul y y)) (mul z z) 809%Z ltac:(lia) G2 F3) as (G3 & W3); [lra|lra|].
  split; [exact G3|]. change (809 + 1)%Z with 810%Z in W3. lra.
Qed.

(** What is no sum with a minus sign. *)
Definition unsigned (x : double) : Prop := is_nan x = true \/ Bsign x = false.

Lemma infinity_unsigned : forall x : double, B2SF x = binary_overflow 53 1024 mode_NE false -> unsigned x.
Proof. intros x H. right. destruct x as [|[]| |]; try reflexivity; discriminate. Qed.

Lemma square_unsigned : forall x : double, unsigned (Bmult mode_NE x x).
Proof.
  intros x. pose proof (Bmult_correct 53 1024 precise bounded mode_NE x x) as C. destruct Rlt_bool.
  - destruct C as (_ & _ & C). unfold unsigned. destruct (is_nan (Bmult mode_NE x x)); [now left|right].
    rewrite C by reflexivity. now destruct (Bsign x).
  - apply infinity_unsigned. now destruct (Bsign x).
Qed.

Lemma sum_unsigned : forall x y : double, unsigned x -> unsigned y -> unsigned (Bplus mode_NE x y).
Proof.
  intros x y Ux Uy.
  destruct (is_finite x) eqn:Fx; [destruct (is_finite y) eqn:Fy|].
  - assert (P : forall v : double, is_finite v = true -> unsigned v -> Bsign v = false /\ 0 <= B2R v).
    { intros v Fv [N|N]; [destruct v; discriminate|]. split; [exact N|].
      destruct v as [| | |s m e b]; try discriminate; simpl; [lra|]. simpl in N. subst s. now apply F2R_ge_0. }
    destruct (P x Fx Ux) as (Sx & Px). destruct (P y Fy Uy) as (Sy & Py).
    pose proof (Bplus_correct 53 1024 precise bounded mode_NE x y Fx Fy) as C. destruct Rlt_bool.
    + destruct C as (_ & _ & C). right. rewrite C, Sx, Sy. destruct (Rcompare_spec (B2R x + B2R y) 0); [lra| |]; reflexivity.
    + destruct C as (C & _). rewrite Sx in C. now apply infinity_unsigned.
  - destruct x as [|[]| |], y as [[]|[]| |[]]; try discriminate; destruct Ux, Uy; try discriminate; try (now left); now right.
  - destruct x as [|[]| |], y as [[]|[]| |[]]; try discriminate; destruct Ux, Uy; try discriminate; try (now left); now right.
Qed.

Lemma squares_unsigned : forall p : vec doubles, unsigned (squares p).
Proof.
  intros ((x, y), z). unfold squares.
  repeat (apply sum_unsigned; [|apply square_unsigned]). right. reflexivity.
Qed.

Lemma below_small : forall s : num doubles, unsigned s -> lt s small = true ->
  finite s = true /\ val s <= bpow radix2 (-900).
Proof.
  intros s Us H. destruct (power_exact (-900) ltac:(lia)) as (F & V).
  assert (Fs : finite s = true).
  { destruct s as [|[]| |]; try reflexivity; exfalso.
    - destruct Us; discriminate.
    - simpl in *. destruct (binary_normalize 53 1024 precise bounded mode_NE 1 (-900) false) as [|[]| |]; discriminate.
    - simpl in *. discriminate. }
  split; [exact Fs|]. apply (lt_val s small Fs F) in H. unfold small in H. rewrite V in H. lra.
Qed.

(** ** Powers of two change no digit *)

Lemma rnd_up : forall (x : num doubles) (e : Z), (0 <= e)%Z -> rnd (val x * bpow radix2 e) = val x * bpow radix2 e.
Proof.
  intros x e He. apply round_generic; auto with typeclass_instances.
  change (SpecFloat.fexp 53 1024) with (FLT_exp (-1074) 53). apply mult_bpow_pos_exact_FLT; [|exact He].
  change (FLT_exp (-1074) 53) with (SpecFloat.fexp 53 1024). apply generic_format_B2R.
Qed.

(** Downwards but for those that become subnormal. *)
Lemma rnd_down : forall x : num doubles, bpow radix2 (-422) <= Rabs (val x) ->
  rnd (val x * bpow radix2 (-600)) = val x * bpow radix2 (-600).
Proof.
  intros x B. apply round_generic; auto with typeclass_instances.
  change (SpecFloat.fexp 53 1024) with (FLT_exp (-1074) 53). apply mult_bpow_exact_FLT.
  - change (FLT_exp (-1074) 53) with (SpecFloat.fexp 53 1024). apply generic_format_B2R.
  - assert (M : (-421 <= mag radix2 (val x))%Z) by (apply (mag_ge_bpow radix2 (val x) (-421)); exact B). lia.
Qed.

Lemma rnd_down_error : forall x : num doubles,
  Rabs (rnd (val x * bpow radix2 (-600)) - val x * bpow radix2 (-600)) <= 3 * tiny.
Proof.
  intros x. pose proof tiny_pos. destruct (Rle_lt_dec (bpow radix2 (-422)) (Rabs (val x))) as [B|B].
  - rewrite (rnd_down x B), Rminus_eq_0, Rabs_R0. lra.
  - pose proof (rnd_error (val x * bpow radix2 (-600))) as E.
    assert (T : u * Rabs (val x * bpow radix2 (-600)) <= 2 * tiny).
    { rewrite Rabs_mult, (Rabs_right (bpow radix2 (-600))) by (apply Rle_ge, bpow_ge_0).
      replace (2 * tiny) with (u * (bpow radix2 (-421) * bpow radix2 (-600))).
      - apply Rmult_le_compat_l; [apply Rlt_le, u_pos|]. apply Rmult_le_compat_r; [apply bpow_ge_0|].
        apply Rlt_le. apply Rlt_le_trans with (1 := B). apply bpow_le. lia.
      - unfold u, tiny. change 2 with (bpow radix2 1). rewrite <- !bpow_plus. reflexivity. }
    lra.
Qed.

Lemma far_scaled : forall x y z s, 0 <= s -> far (x * s, y * s, z * s) = far (x, y, z) * s.
Proof.
  intros x y z s Hs. unfold far, square.
  replace (x * s * (x * s) + y * s * (y * s) + z * s * (z * s)) with ((x * x + y * y + z * z) * (s * s)) by ring.
  rewrite sqrt_mult_alt by nra. now rewrite sqrt_square.
Qed.

(** ** The norm at its scale *)

(** What a comparison at any scale says, when the bound is finite there. *)
Lemma root_le_exact : forall (p : vec doubles) (s b : num doubles), finite b = true ->
  le (root (squares (scaled p s))) b = true ->
  let '(x, y, z) := p in
  finite x = true /\ finite y = true /\ finite z = true /\ 0 <= val b /\
  far (rnd (val x * val s), rnd (val y * val s), rnd (val z * val s)) <= val b * (1 + 11 / 4 * u) + delta.
Proof.
  intros ((x, y), z) s b Fb L. pose proof (root_below _ _ Fb L) as Fn.
  apply (le_val _ _ Fn Fb) in L. pose proof (root_finite_exact _ Fn) as E.
  pose proof (root_finite _ Fn) as (Fs & _). unfold scaled in *. apply squares_finite in Fs as (Fx & Fy & Fz).
  apply mul_finite in Fx as (Fx & _ & Vx). apply mul_finite in Fy as (Fy & _ & Vy).
  apply mul_finite in Fz as (Fz & _ & Vz). unfold place in E. rewrite E in L.
  assert (B0 : 0 <= val b) by (eapply Rle_trans; [apply rnd_nonneg, sqrt_pos|exact L]).
  apply norm_exact in L. rewrite Vx, Vy, Vz in L. tauto.
Qed.

(** Where the plain squares are harmless. *)
Lemma norm_le_plain : forall (p : vec doubles) (r : num doubles), finite r = true ->
  le (root (squares (scaled p (whole 1)))) (mul r (whole 1)) = true ->
  far (place p) <= val r * (1 + 3 * u) + delta.
Proof.
  intros p r Fr L. pose proof u_small as (U & _). destruct (whole_val 1 ltac:(lia)) as (F1 & V1). simpl (INR 1) in V1.
  assert (Fm : finite (mul r (whole 1)) = true /\ val (mul r (whole 1)) = val r).
  { pose proof (Bmult_correct 53 1024 precise bounded mode_NE r (whole 1 : num doubles)) as C.
    change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (B2R (r : double) * B2R (whole 1 : num doubles)))
      with (rnd (val r * val (whole 1))) in C.
    rewrite V1, Rmult_1_r, rnd_val in C. rewrite Rlt_bool_true in C by apply abs_B2R_lt_emax.
    destruct C as (C & D & _). split; [|exact C]. simpl in *. unfold double in *. now rewrite D, Fr. }
  destruct Fm as (Fm & Vm). apply (root_le_exact p _ _ Fm) in L. destruct p as ((x, y), z).
  destruct L as (_ & _ & _ & B & L). rewrite V1, !Rmult_1_r, !rnd_val, Vm in L. rewrite Vm in B.
  unfold place. assert (0 <= u * val r) by (apply Rmult_le_pos; lra). lra.
Qed.

(** Where they vanish. *)
Lemma norm_le_up : forall (p : vec doubles) (r : num doubles), finite r = true -> 0 < val r ->
  lt (squares p) small = true -> le (root (squares (scaled p up))) (mul r up) = true ->
  far (place p) <= val r * (1 + 3 * u) + delta.
Proof.
  intros p r Fr Pr Hs L. pose proof u_small as (U & U'). pose proof delta_pos as D.
  assert (Ur : 0 <= u * val r) by (apply Rmult_le_pos; lra).
  destruct (Rle_lt_dec (bpow radix2 400) (val r)) as [Big|Low].
  - (* The radius is large, and all that vanishes is near. *)
    destruct (below_small _ (squares_unsigned p) Hs) as (Fs & Vs).
    destruct p as ((x, y), z).
    assert (Ss : val (squares (x, y, z)) =
      rnd (rnd (rnd (val x * val x) + rnd (val y * val y)) + rnd (val z * val z))).
    { unfold squares in *. apply add_finite in Fs as (Fs & Fz & ->). apply add_finite in Fs as (Fs & Fy & ->).
      apply add_finite in Fs as (_ & Fx & ->). apply mul_finite in Fx as (_ & _ & ->).
      apply mul_finite in Fy as (_ & _ & ->). apply mul_finite in Fz as (_ & _ & ->).
      destruct zero_val as (_ & ->). now rewrite Rplus_0_l, rnd_rnd. }
    rewrite Ss in Vs.
    assert (N : rnd (sqrt (rnd (rnd (rnd (val x * val x) + rnd (val y * val y)) + rnd (val z * val z)))) <=
      bpow radix2 (-450)).
    { replace (bpow radix2 (-450)) with (rnd (bpow radix2 (-450))).
      - apply rnd_le. rewrite <- (sqrt_square (bpow radix2 (-450))) by apply bpow_ge_0. apply sqrt_le_1_alt.
        now rewrite power_square.
      - apply round_generic; auto with typeclass_instances. apply power_format. lia. }
    apply norm_exact in N. unfold place.
    assert (M : bpow radix2 (-450) * 2 <= bpow radix2 400).
    { change 2 with (bpow radix2 1). rewrite <- bpow_plus. apply bpow_le. lia. }
    pose proof (bpow_ge_0 radix2 (-450)).
    assert (bpow radix2 (-450) * (11 / 4 * u) <= bpow radix2 (-450) * 1) by (apply Rmult_le_compat_l; lra). lra.
  - (* At the scale, nothing is rounded. *)
    destruct (power_exact 600 ltac:(lia)) as (Fu & Vu). fold (up : num doubles) in Fu, Vu.
    assert (B : Rabs (val r * val up) <= bpow radix2 1000).
    { rewrite Vu, Rabs_right by (apply Rle_ge, Rmult_le_pos; [lra|apply bpow_ge_0]).
      replace (bpow radix2 1000) with (bpow radix2 400 * bpow radix2 600) by (rewrite <- bpow_plus; reflexivity).
      apply Rmult_le_compat_r; [apply bpow_ge_0|lra]. }
    destruct (mul_bounded r up 1000 ltac:(lia) Fr Fu B) as (Fm & Vm). rewrite Vu, rnd_up in Vm by lia.
    apply (root_le_exact p _ _ Fm) in L. destruct p as ((x, y), z). destruct L as (_ & _ & _ & _ & L).
    rewrite Vu, !rnd_up, Vm, far_scaled in L by (try lia; apply bpow_ge_0). unfold place.
    assert (P : 1 <= bpow radix2 600) by (change 1 with (bpow radix2 0); apply bpow_le; lia).
    set (s := bpow radix2 600) in *. apply Rmult_le_reg_r with s; [lra|].
    assert (delta <= delta * s) by (rewrite <- (Rmult_1_r delta) at 1; apply Rmult_le_compat_l; lra).
    assert (0 <= u * val r * s) by (apply Rmult_le_pos; lra). nra.
Qed.

(** Where they overflow. *)
Lemma norm_le_down : forall (p : vec doubles) (r : num doubles), finite r = true -> 0 < val r ->
  lt (squares p) large = false -> le (root (squares (scaled p down))) (mul r down) = true ->
  far (place p) <= val r * (1 + 3 * u) + delta.
Proof.
  intros p r Fr Pr Hs L. pose proof u_small as (U & U'). pose proof delta_pos as D. pose proof tiny_pos as T.
  destruct (power_exact (-600) ltac:(lia)) as (Fd & Vd). fold (down : num doubles) in Fd, Vd.
  pose proof (bpow_gt_0 radix2 (-600)) as Ps.
  assert (B : Rabs (val r * val down) <= bpow radix2 424).
  { rewrite Vd, Rabs_mult, (Rabs_right (bpow radix2 (-600))) by lra.
    replace (bpow radix2 424) with (bpow radix2 1024 * bpow radix2 (-600)) by (rewrite <- bpow_plus; reflexivity).
    apply Rmult_le_compat_r; [lra|]. apply Rlt_le, abs_B2R_lt_emax. }
  destruct (mul_bounded r down 424 ltac:(lia) Fr Fd B) as (Fm & Vm). rewrite Vd in Vm.
  apply (root_le_exact p _ _ Fm) in L. destruct p as ((x, y), z). destruct L as (Fx & Fy & Fz & _ & L).
  rewrite Vd, Vm in L.
  set (s := bpow radix2 (-600)) in *.
  assert (Bd : delta <= bpow radix2 (-500)) by (apply bpow_le; lia).
  assert (Bt : tiny <= bpow radix2 (-500)) by (apply bpow_le; lia).
  destruct (Rle_lt_dec (bpow radix2 400) (val r)) as [Big|Low].
  - assert (Er : rnd (val r * s) = val r * s).
    { apply rnd_down. rewrite Rabs_right by lra. apply Rle_trans with (2 := Big). apply bpow_le. lia. }
    rewrite Er in L.
    assert (N : near (rnd (val x * s), rnd (val y * s), rnd (val z * s)) (val x * s, val y * s, val z * s) (3 * tiny)).
    { apply near_sym. repeat split; apply rnd_down_error. }
    apply (far_near _ _ _ _ L) in N. rewrite far_scaled in N by lra. unfold place.
    apply Rmult_le_reg_r with s; [exact Ps|].
    (* What the scale makes of the underflows is nothing beside the radius. *)
    assert (Small : delta + 6 * tiny <= / 4 * u * (val r * s)).
    { apply Rle_trans with (bpow radix2 (-2) * bpow radix2 (-53) * (bpow radix2 400 * s)).
      - unfold s. rewrite <- !bpow_plus. simpl (-2 + -53 + (400 + -600))%Z.
        apply Rle_trans with (7 * bpow radix2 (-500)); [lra|].
        apply Rle_trans with (bpow radix2 3 * bpow radix2 (-500)).
        + apply Rmult_le_compat_r; [apply bpow_ge_0|]. simpl. lra.
        + rewrite <- bpow_plus. apply bpow_le. lia.
      - change (bpow radix2 (-53)) with u. replace (bpow radix2 (-2)) with (/ 4) by (simpl; lra).
        apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; lra. }
    assert (0 <= delta * s) by (apply Rmult_le_pos; lra). nra.
  - (* A position that is near has squares that do not overflow. *)
    exfalso.
    assert (R1 : rnd (val r * s) <= bpow radix2 (-200)).
    { replace (bpow radix2 (-200)) with (rnd (bpow radix2 (-200))).
      - apply rnd_le. replace (bpow radix2 (-200)) with (bpow radix2 400 * s)
          by (unfold s; rewrite <- bpow_plus; reflexivity).
        apply Rmult_le_compat_r; lra.
      - apply round_generic; auto with typeclass_instances. apply power_format. lia. }
    assert (F : far (rnd (val x * s), rnd (val y * s), rnd (val z * s)) <= bpow radix2 (-198)).
    { apply Rle_trans with (1 := L). pose proof (bpow_ge_0 radix2 (-200)).
      assert (rnd (val r * s) * (1 + 11 / 4 * u) <= bpow radix2 (-200) * 2).
      { apply Rmult_le_compat; try lra. apply rnd_nonneg. apply Rmult_le_pos; lra. }
      assert (bpow radix2 (-500) <= bpow radix2 (-200)) by (apply bpow_le; lia).
      assert (E : bpow radix2 (-198) = 4 * bpow radix2 (-200)).
      { change 4 with (bpow radix2 2). rewrite <- bpow_plus. reflexivity. }
      lra. }
    destruct (component_le_far _ _ _ _ F) as (Cx & Cy & Cz).
    assert (K : forall v : num doubles, Rabs (rnd (val v * s)) <= bpow radix2 (-198) -> Rabs (val v) <= bpow radix2 404).
    { intros v C. pose proof (rnd_down_error v) as E. fold s in E.
      assert (A : Rabs (val v * s) <= bpow radix2 (-196)).
      { replace (val v * s) with (rnd (val v * s) - (rnd (val v * s) - val v * s)) by ring.
        eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp.
        assert (bpow radix2 (-500) <= bpow radix2 (-198)) by (apply bpow_le; lia).
        assert (Q : bpow radix2 (-196) = 4 * bpow radix2 (-198)).
        { change 4 with (bpow radix2 2). rewrite <- bpow_plus. reflexivity. }
        lra. }
      rewrite Rabs_mult, (Rabs_right s) in A by lra. apply Rmult_le_reg_r with s; [exact Ps|].
      replace (bpow radix2 404 * s) with (bpow radix2 (-196)) by (unfold s; rewrite <- bpow_plus; reflexivity).
      exact A. }
    destruct (squares_bounded x y z Fx Fy Fz (K x Cx) (K y Cy) (K z Cz)) as (Fq & Vq).
    destruct (power_exact 1000 ltac:(lia)) as (Fl & Vl). fold (large : num doubles) in Fl, Vl.
    apply (not_lt_val _ large Fq Fl) in Hs. rewrite Vl in Hs.
    assert (bpow radix2 810 < bpow radix2 1000) by (apply bpow_lt; lia). lra.
Qed.

(** What is not above a bound by the norm that is computed is not above it, but for the roundings. *)
Theorem norm_le_exact : forall (p : vec doubles) (r : num doubles), finite r = true -> lt zero r = true ->
  norm_le p r = true -> far (place p) <= val r * (1 + 3 * u) + delta.
Proof.
  intros p r Fr Pr L. destruct zero_val as (Fz & Z). apply (lt_val zero r Fz Fr) in Pr. rewrite Z in Pr.
  unfold norm_le, norm, scale, select_lt in L. destruct (lt (squares p) small) eqn:A; [now apply norm_le_up|].
  destruct (lt (squares p) large) eqn:B; [now apply norm_le_plain|now apply norm_le_down].
Qed.

(** (a) What [inside] says in exact arithmetic. *)
Theorem inside_exact : forall (p : vec doubles) (radius : num doubles), inside p radius = true ->
  0 < val radius /\ far (place p) <= val radius * (1 + 3 * u) + delta.
Proof.
  intros p radius H. unfold inside in H. rewrite !andb_true_iff in H. destruct H as (((_ & Fr) & P) & L).
  split; [|now apply norm_le_exact].
  destruct zero_val as (Fz & Z). apply (lt_val zero radius Fz Fr) in P. now rewrite Z in P.
Qed.
