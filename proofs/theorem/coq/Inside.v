(** A point that the kernel computes to be inside lies inside in exact arithmetic, but for the roundings. *)

From Coq Require Import ZArith Reals Psatz Bool.
From Flocq Require Import Core BinarySingleNaN.
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

(** What a computed norm says, in real numbers. *)
Lemma norm_finite : forall p : vec doubles, finite (norm p) = true ->
  let '(x, y, z) := place p in
  val (norm p) = rnd (sqrt (rnd (rnd (rnd (x * x) + rnd (y * y)) + rnd (z * z)))).
Proof.
  intros ((x, y), z) H. unfold norm in *. unfold place.
  apply root_finite in H as (H & ->).
  apply add_finite in H as (H & Hz & ->).
  apply add_finite in H as (H & Hy & ->).
  apply add_finite in H as (_ & Hx & ->).
  apply mul_finite in Hx as (_ & _ & ->).
  apply mul_finite in Hy as (_ & _ & ->).
  apply mul_finite in Hz as (_ & _ & ->).
  destruct zero_val as (_ & ->). now rewrite Rplus_0_l, rnd_rnd.
Qed.

Lemma rnd_lower : forall x, 0 <= x -> x * (1 - u) - tiny <= rnd x.
Proof.
  intros x H. pose proof (rnd_error x) as E. rewrite (Rabs_right x) in E by lra. apply Rabs_le_inv in E. lra.
Qed.

Lemma u_small : 0 < u <= / 1000.
Proof. rewrite u_value. lra. Qed.

Lemma relative_square : 1 <= (1 - u) ^ 5 * ((1 + 3 * u) * (1 + 3 * u)).
Proof.
  pose proof u_small as H. set (e := u) in *. clearbody e.
  assert (B : 1 - 5 * e <= (1 - e) ^ 5).
  { assert (S : 1 - 2 * e <= (1 - e) * (1 - e)) by nra.
    assert (T : (1 - 2 * e) * (1 - 2 * e) <= (1 - e) * (1 - e) * ((1 - e) * (1 - e))) by nra.
    assert (U : 1 - 4 * e <= (1 - e) * (1 - e) * ((1 - e) * (1 - e))) by nra.
    replace ((1 - e) ^ 5) with ((1 - e) * (1 - e) * ((1 - e) * (1 - e)) * (1 - e)) by ring. nra. }
  assert (0 <= (1 + 3 * e) * (1 + 3 * e)) by nra.
  apply Rle_trans with ((1 - 5 * e) * ((1 + 3 * e) * (1 + 3 * e))); [nra|].
  now apply Rmult_le_compat_r.
Qed.

Lemma norm_exact : forall x y z r,
  rnd (sqrt (rnd (rnd (rnd (x * x) + rnd (y * y)) + rnd (z * z)))) <= r ->
  far (x, y, z) <= r * (1 + 3 * u) + delta.
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
  pose proof relative_square as K. set (k := 1 + 3 * u) in *. assert (Hk : 1 <= k <= 2) by (unfold k; lra).
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

(** (a) What [inside] says in exact arithmetic. *)
Theorem inside_exact : forall (p : vec doubles) (radius : num doubles), inside p radius = true ->
  0 < val radius /\ far (place p) <= val radius * (1 + 3 * u) + delta.
Proof.
  intros p radius H. unfold inside in H. rewrite !andb_true_iff in H. destruct H as (((_ & Fr) & P) & L).
  destruct zero_val as (Fz & Z). apply (lt_val zero radius Fz Fr) in P. rewrite Z in P. split; [exact P|].
  assert (Fn : finite (norm p) = true).
  { destruct p as ((x, y), z). exact (root_below _ radius Fr L). }
  apply (le_val _ _ Fn Fr) in L. pose proof (norm_finite p Fn) as E.
  destruct p as ((x, y), z). unfold place in *. rewrite E in L. now apply norm_exact.
Qed.

(** The same of any norm that is not above a bound: what the speed limit says. *)
Theorem norm_below_exact : forall (v : vec doubles) (bound : num doubles), finite bound = true ->
  le (norm v) bound = true -> far (place v) <= val bound * (1 + 3 * u) + delta.
Proof.
  intros v bound Fb L. assert (Fn : finite (norm v) = true).
  { destruct v as ((x, y), z). exact (root_below _ bound Fb L). }
  apply (le_val _ _ Fn Fb) in L. pose proof (norm_finite v Fn) as E.
  destruct v as ((x, y), z). unfold place in *. rewrite E in L. now apply norm_exact.
Qed.
