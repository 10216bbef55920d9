(** One tick: how far the computed end is from where an exact plant gets to. *)

From Coq Require Import ZArith Reals Psatz Bool.
From Flocq Require Import Core BinarySingleNaN.
From NCP Require Import Kernel Doubles Ball Inside.

Open Scope R_scope.

(** The exact part of tick [k], [k*dt, (k+1)*dt), that lies before [t]. *)
Definition share (k : nat) (dt t : R) : R := Rmax 0 (Rmin dt (t - INR k * dt)).

(** How far a computed end may be from the exact one, in each component: a plant at the computed start moves with a
    velocity of at most [v] in each component for a part of [t] ms, and the end is computed inside [r]. *)
Definition step_error (r v t : R) : R := 2 * u * r + 6 * u * (v * t / 1000) + delta * (1 + v).

Lemma step_error_nonneg : forall r v t, 0 <= r -> 0 <= v -> 0 <= t -> 0 <= step_error r v t.
Proof.
  intros r v t Hr Hv Ht. unfold step_error. pose proof u_pos. pose proof delta_pos.
  assert (0 <= v * t) by now apply Rmult_le_pos. assert (0 <= u * r) by (apply Rmult_le_pos; lra).
  assert (0 <= u * (v * t / 1000)) by (apply Rmult_le_pos; lra). assert (0 <= delta * (1 + v)) by (apply Rmult_le_pos; lra).
  lra.
Qed.

(** ** The computed share of a tick *)

Lemma sub_no_overflow : forall x y : num doubles, finite x = true -> finite y = true -> 0 <= val y <= val x ->
  finite (sub x y) = true.
Proof.
  intros x y Fx Fy H. simpl in *.
  pose proof (Bminus_correct 53 1024 precise bounded mode_NE x y Fx Fy) as C. rewrite Rlt_bool_true in C; [tauto|].
  fold (rnd (B2R (x : double) - B2R (y : double))). unfold val in H. rewrite Rabs_right.
  - apply Rle_lt_trans with (rnd (B2R (x : double))); [apply rnd_le; lra|].
    change (B2R (x : double)) with (val x). rewrite rnd_val. unfold val.
    apply Rle_lt_trans with (Rabs (B2R (x : double))); [apply Rle_abs|]. apply abs_B2R_lt_emax.
  - apply Rle_ge, rnd_nonneg. lra.
Qed.

Lemma emax_big : 120000 < bpow radix2 1024.
Proof. apply Rlt_trans with (bpow radix2 17); [simpl; lra|]. apply bpow_lt. lia. Qed.

Lemma positive_sign : forall x : double, 0 < B2R x -> Bsign x = false.
Proof.
  intros [s|s| |[] m e b] P; simpl in *; try reflexivity; try lra.
  exfalso. apply (Rlt_irrefl 0). eapply Rlt_trans; [exact P|]. now apply F2R_lt_0.
Qed.

(** A product that overflows is below nothing. *)
Lemma product_below : forall x y t : double, is_finite x = true -> is_finite y = true ->
  x = B754_zero false \/ 0 < B2R x -> 0 < B2R y -> Bltb (Bmult mode_NE x y) t = true ->
  is_finite (Bmult mode_NE x y) = true.
Proof.
  intros x y t Fx Fy Px Py L.
  pose proof (Bmult_correct 53 1024 precise bounded mode_NE x y) as C.
  destruct Rlt_bool.
  - destruct C as (_ & -> & _). now rewrite Fx, Fy.
  - assert (N : Bsign x = false) by (destruct Px as [-> | Px]; [reflexivity|now apply positive_sign]).
    rewrite N, (positive_sign y Py) in C. simpl in C. unfold Bltb in L. rewrite C in L.
    destruct t as [|[]| |[]]; simpl in *; discriminate.
Qed.

Lemma start_before : forall (k : nat) (dt ttl : num doubles), (Z.of_nat k <= 2 ^ 53)%Z ->
  finite dt = true -> 0 < val dt -> finite ttl = true -> val ttl <= 60000 ->
  let start := mul (whole k) dt in
  if lt start ttl then finite start = true /\ val start = rnd (INR k * val dt) /\ rnd (INR k * val dt) < val ttl
  else val ttl <= rnd (INR k * val dt).
Proof.
  intros k dt ttl Hk Fd Pd Ft Ht start. destruct (whole_val k Hk) as (Fk & Vk).
  destruct (lt start ttl) eqn:L.
  - assert (Fs : finite start = true).
    { apply (product_below (whole k : num doubles) dt ttl Fk Fd); [|exact Pd|exact L].
      destruct k as [|k]; [now left|right]. fold (val (whole (Datatypes.S k))). rewrite Vk. apply lt_0_INR. lia. }
    pose proof (mul_finite (whole k) dt Fs) as (_ & _ & E). fold start in E. rewrite Vk in E.
    split; [exact Fs|split; [exact E|]]. rewrite <- E. now apply lt_val.
  - pose proof (Bmult_correct 53 1024 precise bounded mode_NE (whole k : num doubles) dt) as C.
    change (round_mode mode_NE) with ZnearestE in C. fold (val (whole k)) in C. fold (val dt) in C. rewrite Vk in C.
    fold (rnd (INR k * val dt)) in C.
    destruct (Rlt_bool_spec (Rabs (rnd (INR k * val dt))) (bpow radix2 1024)) as [B|B].
    + destruct C as (C & D & _).
      assert (Fs : finite start = true) by (unfold start; simpl in *; unfold double in *; rewrite D, Fk, Fd; reflexivity).
      rewrite <- C. change (val ttl <= val start). now apply not_lt_val.
    + pose proof emax_big. rewrite Rabs_right in B; [lra|].
      apply Rle_ge, rnd_nonneg. apply Rmult_le_pos; [apply pos_INR|lra].
Qed.

Lemma share_error : forall (k : nat) (dt ttl : num doubles), (Z.of_nat k <= 2 ^ 53)%Z ->
  finite dt = true -> 0 < val dt -> finite ttl = true -> 0 <= val ttl <= 60000 ->
  let part := tick_share_ms k dt ttl in
  0 <= val part <= val ttl /\ Rabs (val part - share k (val dt) (val ttl)) <= 3 * u * val ttl + 3 * tiny.
Proof.
  intros k dt ttl Hk Fd Pd Ft (Ht & Ht') part. unfold part, tick_share_ms, share.
  pose proof (start_before k dt ttl Hk Fd Pd Ft Ht') as B. cbv zeta in B |- *.
  set (start := mul (whole k) dt) in *.
  assert (PK : 0 <= INR k * val dt) by (apply Rmult_le_pos; [apply pos_INR|lra]).
  set (K := INR k * val dt) in *. set (T := val ttl) in *. set (d := val dt) in *.
  pose proof (rnd_error K) as EK. rewrite (Rabs_right K) in EK by lra. apply Rabs_le_inv in EK.
  pose proof u_small as (U & U'). pose proof tiny_pos as P.
  destruct (lt start ttl); cbn [negb].
  - destruct B as (Fs & Vs & Bs). rewrite <- Vs in *.
    assert (S0 : 0 <= val start) by (rewrite Vs; now apply rnd_nonneg).
    set (rest := sub ttl start) in *.
    assert (Fr : finite rest = true) by (apply sub_no_overflow; auto; fold T; lra).
    pose proof (sub_finite ttl start Fr) as (_ & _ & Vr). fold rest T in Vr.
    pose proof (rnd_error (T - val start)) as ER. rewrite <- Vr, (Rabs_right (T - val start)) in ER by lra.
    apply Rabs_le_inv in ER.
    assert (R0 : 0 <= val rest) by (rewrite Vr; apply rnd_nonneg; lra).
    assert (R1 : val rest <= T).
    { rewrite Vr. replace T with (rnd T) at 2 by apply rnd_val. apply rnd_le. lra. }
    assert (D : Rabs (val rest - (T - K)) <= 3 * u * T + 3 * tiny).
    { assert (K <= 2 * T + 2 * tiny) by nra.
      assert (K1 : u * K <= u * ((T + tiny) * (1 + 2 * u))).
      { apply Rmult_le_compat_l; [lra|]. nra. }
      assert (K2 : u * ((T + tiny) * (1 + 2 * u)) <= 3 / 2 * u * T + tiny).
      { replace (u * ((T + tiny) * (1 + 2 * u))) with (u * T * (1 + 2 * u) + u * (1 + 2 * u) * tiny) by ring.
        assert (0 <= u * T) by (apply Rmult_le_pos; lra).
        assert (u * T * (1 + 2 * u) <= u * T * (3 / 2)) by (apply Rmult_le_compat_l; lra).
        assert (u * (1 + 2 * u) * tiny <= 1 * tiny) by (apply Rmult_le_compat_r; nra).
        lra. }
      assert (K3 : u * (T - val start) <= u * T) by nra.
      assert (0 <= u * T) by (apply Rmult_le_pos; lra).
      apply Rabs_le. split; lra. }
    apply Rabs_le_inv in D.
    destruct (lt dt rest) eqn:L.
    + apply (lt_val dt rest Fd Fr) in L. fold d in L. fold d. split; [lra|].
      apply Rabs_le. unfold Rmax, Rmin. destruct (Rle_dec d (T - K)); destruct Rle_dec; lra.
    + apply (not_lt_val dt rest Fd Fr) in L. fold d in L. split; [lra|].
      apply Rabs_le. unfold Rmax, Rmin. destruct (Rle_dec d (T - K)); destruct Rle_dec; lra.
  - destruct zero_val as (_ & ->). split; [lra|].
    assert (G : Rmax 0 (Rmin d (T - K)) <= u * T + tiny).
    { assert (0 <= u * T) by (apply Rmult_le_pos; lra).
      apply Rmax_lub; [lra|]. apply Rle_trans with (T - K); [apply Rmin_r|].
      destruct (Rle_lt_dec T K); [lra|]. assert (u * K <= u * T) by (apply Rmult_le_compat_l; lra). lra. }
    pose proof (Rmax_l 0 (Rmin d (T - K))). assert (0 <= u * T) by (apply Rmult_le_pos; lra).
    apply Rabs_le. split; lra.
Qed.

(** ** The computed end of a tick *)

Lemma component_step : forall x v s part r b t,
  0 < r -> 0 <= t -> Rabs v <= b -> 0 <= part <= t -> Rabs (part - s) <= 3 * u * t + 3 * tiny ->
  Rabs (rnd (x + rnd (v * rnd (part / 1000)))) <= r * (1 + 3 * u) + delta ->
  Rabs (rnd (x + rnd (v * rnd (part / 1000))) - (x + v * s / 1000)) <= step_error r b t.
Proof.
  intros x v s part r b t Hr Ht Hv Hp Hs He.
  pose proof u_small as (U & U'). pose proof tiny_pos as P. pose proof delta_pos as D. pose proof tiny_delta as TD.
  assert (TS : tiny <= delta / 1000000).
  { unfold tiny, delta. apply Rle_trans with (bpow radix2 (-536 + -30)); [apply bpow_le; lia|].
    rewrite bpow_plus. assert (bpow radix2 (-30) <= / 1000000) by (simpl; lra). pose proof (bpow_gt_0 radix2 (-536)). nra. }
  assert (Pv : 0 <= b) by (pose proof (Rabs_pos v); lra).
  set (q := part / 1000) in *. assert (Hq : 0 <= q) by (unfold q; lra).
  assert (Hqt : q <= t / 1000) by (unfold q; lra).
  set (c := rnd q) in *. pose proof (rnd_error q) as Ec. fold c in Ec. rewrite (Rabs_right q) in Ec by lra.
  set (m := rnd (v * c)) in *. pose proof (rnd_error (v * c)) as Em. fold m in Em.
  set (e := rnd (x + m)) in *. pose proof (rnd_error (x + m)) as Ee. fold e in Ee.
  (* |x + m|, by the end. *)
  assert (Axm : Rabs (x + m) <= 3 / 2 * (r + delta)).
  { assert (Rabs (x + m) <= Rabs e + (u * Rabs (x + m) + tiny)).
    { replace (x + m) with (e - (e - (x + m))) at 1 by ring. eapply Rle_trans; [apply Rabs_triang|].
      rewrite Rabs_Ropp. lra. }
    pose proof (Rabs_pos (x + m)). assert (u * Rabs (x + m) <= Rabs (x + m) / 1000) by nra. nra. }
  assert (Cq : Rabs (c - q) <= u * (t / 1000) + tiny).
  { eapply Rle_trans; [exact Ec|]. assert (u * q <= u * (t / 1000)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Vc : Rabs (v * c) <= b * (t / 1000) * (11 / 10) + b * tiny).
  { rewrite Rabs_mult. assert (Rabs c <= t / 1000 * (11 / 10) + tiny).
    { replace c with ((c - q) + q) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite (Rabs_right q) by lra.
      assert (u * (t / 1000) <= t / 1000 / 1000) by nra. lra. }
    apply Rle_trans with (b * (t / 1000 * (11 / 10) + tiny)); [|right; ring].
    apply Rmult_le_compat; auto using Rabs_pos. }
  assert (V1 : Rabs (v * c - v * q) <= b * (u * (t / 1000) + tiny)).
  { replace (v * c - v * q) with (v * (c - q)) by ring. rewrite Rabs_mult.
    apply Rmult_le_compat; auto using Rabs_pos. }
  assert (V2 : Rabs (v * q - v * s / 1000) <= b * ((3 * u * t + 3 * tiny) / 1000)).
  { unfold q. replace (v * (part / 1000) - v * s / 1000) with (v * ((part - s) / 1000)) by field. rewrite Rabs_mult.
    apply Rmult_le_compat; auto using Rabs_pos. unfold Rdiv. rewrite Rabs_mult, (Rabs_right (/ 1000)) by lra.
    apply Rmult_le_compat_r; lra. }
  replace (e - (x + v * s / 1000)) with ((e - (x + m)) + ((m - v * c) + ((v * c - v * q) + (v * q - v * s / 1000)))) by ring.
  eapply Rle_trans; [apply Rabs_triang|].
  eapply Rle_trans; [apply Rplus_le_compat_l, Rabs_triang|].
  eapply Rle_trans; [apply Rplus_le_compat_l, Rplus_le_compat_l, Rabs_triang|].
  unfold step_error.
  assert (W1 : u * Rabs (x + m) <= u * (3 / 2 * (r + delta))) by (apply Rmult_le_compat_l; lra).
  assert (W2 : u * Rabs (v * c) <= u * (b * (t / 1000) * (11 / 10) + b * tiny)) by (apply Rmult_le_compat_l; lra).
  assert (Bt : 0 <= b * tiny) by (apply Rmult_le_pos; lra).
  assert (Ut : u * (b * tiny) <= b * tiny) by nra.
  assert (Ud : u * delta <= delta / 1000) by nra.
  assert (Bd : b * tiny <= b * (delta / 1000000)) by (apply Rmult_le_compat_l; lra).
  assert (X : 0 <= u * (b * t)) by (apply Rmult_le_pos; [lra|now apply Rmult_le_pos]).
  assert (Y : 0 <= u * r) by (apply Rmult_le_pos; lra).
  assert (Z : 0 <= b * delta) by (apply Rmult_le_pos; lra).
  lra.
Qed.

(** (b) One step: a computed end lies inside but for the roundings, and near the exact one. *)
Theorem after_exact : forall (from v e : vec doubles) (time radius : num doubles) (s b t : R),
  after from v time radius = Some e ->
  slow (place v) b -> 0 <= val time <= t -> Rabs (val time - s) <= 3 * u * t + 3 * tiny ->
  far (place e) <= val radius * (1 + 3 * u) + delta /\
  near (moved (place from) (place v) s) (place e) (step_error (val radius) b t).
Proof.
  intros from v e time radius s b t H Hv Hp Hs. unfold after in H. cbv zeta in H.
  destruct (inside _ radius) eqn:I; [|discriminate].
  assert (E : e = travel from v (div time thousand)) by congruence. clear H. subst e.
  assert (A : all_finite (travel from v (div time thousand)) = true).
  { unfold inside in I. rewrite !andb_true_iff in I. tauto. }
  apply inside_exact in I as (Hr & I). split; [exact I|].
  destruct from as ((x, y), z). destruct v as ((a, b'), c). unfold all_finite, travel in A. rewrite !andb_true_iff in A.
  destruct A as ((Ax & Ay) & Az). unfold travel, place in *.
  assert (T0 : val thousand <> 0) by (destruct thousand_val as (_ & ->); lra).
  assert (V : forall x v : num doubles, finite (add x (mul v (div time thousand))) = true ->
    val (add x (mul v (div time thousand))) = rnd (val x + rnd (val v * rnd (val time / 1000)))).
  { intros p w F. apply add_finite in F as (_ & F & ->). apply mul_finite in F as (_ & F & ->).
    apply div_finite in F as (_ & ->); [|exact T0]. destruct thousand_val as (_ & ->). reflexivity. }
  apply component_le_far in I. rewrite (V _ _ Ax), (V _ _ Ay), (V _ _ Az) in I. destruct I as (Ix & Iy & Iz).
  unfold slow, near in Hv. rewrite !Rminus_0_r in Hv. destruct Hv as (Va & Vb & Vc).
  unfold near, moved. rewrite (V _ _ Ax), (V _ _ Ay), (V _ _ Az).
  assert (Ht : 0 <= t) by lra.
  repeat split; apply component_step with (part := val time); assumption.
Qed.
