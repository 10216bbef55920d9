(** Which tick a plant plays, by the doubles that it computes, against the exact age of its command. *)

From Coq Require Import ZArith Reals Psatz Bool Arith.
From Flocq Require Import Core BinarySingleNaN.
From NCP Require Import Kernel Doubles Ball Inside Step Horizon.

Open Scope R_scope.

(** How far from its exact instant, in ms, a plant may change over to the next tick or hold: its clock reads the age
    within [kappa] ms, and the deadline is at [t] ms. *)
Definition slack (t kappa : R) : R := kappa + 8 * u * t + delta.

Lemma tiny_slack : 10000 * tiny <= delta.
Proof.
  unfold tiny, delta. apply Rle_trans with (bpow radix2 14 * bpow radix2 (-1075)).
  - apply Rmult_le_compat_r; [apply bpow_ge_0|]. simpl. lra.
  - rewrite <- bpow_plus. apply bpow_le. lia.
Qed.

(** The exact age, in ms, at a reading of the clock, in s. *)
Definition exact_age (now_s received_s : num doubles) : R := (val now_s - val received_s) * 1000.

Lemma product_below_le : forall x y t : double, is_finite x = true -> is_finite y = true -> is_finite t = true ->
  0 <= B2R x -> 0 < B2R y -> Bleb (Bmult mode_NE x y) t = true -> is_finite (Bmult mode_NE x y) = true.
Proof.
  intros x y t Fx Fy Ft Px Py L. pose proof (Bmult_correct 53 1024 precise bounded mode_NE x y) as C.
  destruct (Rlt_bool_spec (Rabs (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (B2R x * B2R y)))
    (bpow radix2 1024)) as [B|B].
  - destruct C as (_ & -> & _). now rewrite Fx, Fy.
  - destruct (Req_dec (B2R x) 0) as [Z|Z].
    { rewrite Z, Rmult_0_l, round_0, Rabs_R0 in B by auto with typeclass_instances.
      pose proof (bpow_gt_0 radix2 1024). lra. }
    rewrite (positive_sign x), (positive_sign y Py) in C by lra. simpl in C. unfold Bleb in L. rewrite C in L.
    destruct t as [|[]| |[]]; simpl in *; discriminate.
Qed.

Lemma age_finite : forall now received ttl : num doubles,
  finite now = true -> finite received = true -> finite ttl = true -> val received <= val now ->
  le (age_ms now received) ttl = true -> finite (sub now received) = true /\ finite (age_ms now received) = true.
Proof.
  intros now received ttl Fn Fr Ft H L. unfold age_ms in *.
  assert (Fs : finite (sub now received) = true).
  { pose proof (Bminus_correct 53 1024 precise bounded mode_NE now received Fn Fr) as C.
    destruct (Rlt_bool_spec (Rabs (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE)
      (B2R (now : double) - B2R (received : double)))) (bpow radix2 1024)) as [B|B]; [simpl; tauto|exfalso].
    destruct C as (C & S). simpl in L. unfold Bleb in L.
    remember (Bminus mode_NE (now : double) received) as d eqn:D. clear D.
    destruct (Bsign (now : double)) eqn:Sn; simpl in C.
    - assert (val now <= 0 /\ 0 <= val received) as (N1 & N2).
      { clear - Sn S Fn Fr. unfold val. split.
        - destruct now as [s|s| |[] m e b]; simpl in *; try lra; try discriminate. now apply F2R_le_0.
        - destruct received as [s|s| |[] m e b]; simpl in *; try lra; try discriminate. now apply F2R_ge_0. }
      assert (E : B2R (now : double) - B2R (received : double) = 0) by (unfold val in *; lra).
      rewrite E, round_0, Rabs_R0 in B by auto with typeclass_instances. pose proof (bpow_gt_0 radix2 1024). lra.
    - destruct d as [|[]| |[]]; simpl in C; try discriminate. destruct ttl as [|[]| |[]]; simpl in *; discriminate. }
  split; [exact Fs|]. destruct thousand_val as (F1 & V1).
  apply (product_below_le (sub now received) (thousand : num doubles) ttl Fs F1 Ft); [| |exact L].
  - pose proof (sub_finite now received Fs) as (_ & _ & E). fold (val (sub now received)). rewrite E.
    apply rnd_nonneg. lra.
  - fold (val thousand). rewrite V1. lra.
Qed.

(** What the watchdog's test says in exact arithmetic. *)
Theorem within_exact : forall (p : plan doubles) (now received : num doubles),
  within_deadline now received (ttl_ms p) = true ->
  let t := val (enforced p) in
  let age := age_ms now received in
  finite now = true /\ finite received = true /\ val received <= val now /\
  finite age = true /\ 0 <= val age <= t /\ Rabs (val age - exact_age now received) <= 3 * u * t + 3000 * tiny.
Proof.
  intros p now received H t age. unfold within_deadline in H.
  destruct (enforced_val p) as (Ft & Ht). unfold t, enforced in *.
  destruct (enforced_ttl_ms (ttl_ms p)) as [ttl|]; [|discriminate].
  destruct (finite now) eqn:Fn; [|discriminate]. destruct (finite received) eqn:Fr; [|discriminate].
  destruct (le received now) eqn:L; [|discriminate]. cbn [negb orb] in H. apply (le_val _ _ Fr Fn) in L.
  destruct (age_finite now received ttl Fn Fr Ft L H) as (Fs & Fa).
  pose proof (le_val _ _ Fa Ft H) as A.
  pose proof (sub_finite _ _ Fs) as (_ & _ & Es). pose proof (mul_finite _ _ Fa) as (_ & _ & Ea).
  fold (age_ms now received) in Ea. fold age in Ea, A, Fa. destruct thousand_val as (_ & V1). rewrite V1, Es in Ea.
  set (d := val now - val received) in *. assert (D : 0 <= d) by (unfold d; lra).
  pose proof (rnd_error d) as E1. pose proof (rnd_nonneg d D) as N1. rewrite (Rabs_right d) in E1 by lra.
  pose proof (rnd_error (rnd d * 1000)) as E2. rewrite (Rabs_right (rnd d * 1000)) in E2 by lra.
  assert (N2 : 0 <= rnd (rnd d * 1000)) by (apply rnd_nonneg; lra). rewrite <- Ea in *.
  pose proof u_small as (U & U'). pose proof tiny_pos as P.
  repeat split; auto. unfold exact_age. fold d.
  apply Rabs_le_inv in E1. apply Rabs_le_inv in E2.
  set (a := val age) in *. set (w := rnd d) in *. set (T := val ttl) in *.
  (* 1000 d, by the computed age. *)
  assert (W : w * 1000 <= a * (1 + 2 * u) + 2 * tiny).
  { assert (w * 1000 * (1 - u) <= a + tiny) by lra.
    assert (w * 1000 * (1 - u) * (1 + 2 * u) <= (a + tiny) * (1 + 2 * u)) by (apply Rmult_le_compat_r; lra).
    assert (1 <= (1 - u) * (1 + 2 * u)) by nra.
    assert (w * 1000 * 1 <= w * 1000 * ((1 - u) * (1 + 2 * u))) by (apply Rmult_le_compat_l; lra).
    assert (u * tiny <= tiny / 1000) by nra. lra. }
  assert (Dd : d * 1000 <= a * (11 / 10) + 2000 * tiny).
  { assert (d * (1 - u) <= w + tiny) by lra.
    assert (u * d <= d / 1000) by nra. assert (u * a <= a / 1000) by nra. lra. }
  assert (K1 : u * (d * 1000) <= u * (T * (11 / 10)) + tiny * 2).
  { apply Rle_trans with (u * (a * (11 / 10) + 2000 * tiny)); [apply Rmult_le_compat_l; lra|].
    assert (u * (a * (11 / 10)) <= u * (T * (11 / 10))) by (apply Rmult_le_compat_l; lra).
    assert (u * (2000 * tiny) <= 2 * tiny) by nra. lra. }
  assert (K2 : u * (w * 1000) <= u * (T * (11 / 10)) + tiny).
  { apply Rle_trans with (u * (a * (1 + 2 * u) + 2 * tiny)); [apply Rmult_le_compat_l; lra|].
    assert (u * (a * (1 + 2 * u)) <= u * (T * (11 / 10))) by (apply Rmult_le_compat_l; nra).
    assert (u * (2 * tiny) <= tiny) by nra. lra. }
  assert (0 <= u * T) by (apply Rmult_le_pos; lra).
  apply Rabs_le. split; lra.
Qed.

(** A quotient of an age and a tick. *)
Lemma quotient : forall age dt : num doubles, finite age = true -> finite dt = true -> 0 <= val age -> 0 < val dt ->
  le zero (div age dt) = true /\
  if finite (div age dt) then val (div age dt) = rnd (val age / val dt)
  else bpow radix2 1024 <= rnd (val age / val dt).
Proof.
  intros age dt Fa Fd Pa Pd.
  assert (Q : 0 <= val age / val dt).
  { unfold Rdiv. apply Rmult_le_pos; [exact Pa|]. apply Rlt_le, Rinv_0_lt_compat, Pd. }
  pose proof (Bdiv_correct 53 1024 precise bounded mode_NE age dt ltac:(unfold val in Pd; lra)) as C.
  change (round_mode mode_NE) with ZnearestE in C. fold (val age) (val dt) in C. fold (rnd (val age / val dt)) in C.
  pose proof (rnd_nonneg _ Q) as Rq.
  destruct (Rlt_bool_spec (Rabs (rnd (val age / val dt))) (bpow radix2 1024)) as [B|B].
  - destruct C as (C & D & _). assert (F : finite (div age dt) = true) by (simpl; unfold double in *; rewrite D; exact Fa).
    rewrite F. split; [|exact C]. destruct zero_val as (Fz & Z).
    apply val_le; [exact Fz|exact F|]. rewrite Z. change (val (div age dt)) with (B2R (Bdiv mode_NE (age : double) dt)). rewrite C. exact Rq.
  - rewrite (Rabs_right _ (Rle_ge _ _ Rq)) in B.
    destruct (Req_dec (val age) 0) as [A0|A0].
    { rewrite A0 in B. unfold Rdiv in B. rewrite Rmult_0_l, rnd_0 in B. pose proof (bpow_gt_0 radix2 1024). lra. }
    rewrite (positive_sign age), (positive_sign dt) in C by (unfold val in *; lra). simpl in C.
    cbn [div doubles finite le]. unfold Bleb. rewrite <- is_finite_SF_B2SF. unfold double in *. rewrite C. simpl. auto.
Qed.

Section Plant.
Context {Q : Sequence}.

(** What a plant does that has accepted a command at [received], without a word since. *)
Definition plays (sent : plan doubles) (received : num doubles) (q : seq Q) (now : num doubles) : option nat :=
  snd (active (Plant (Some q) (Some (received, ttl_ms sent)) false) now (dt_ms sent) (steps sent)).

Lemma plays_case : forall sent received q now, plays sent received q now =
  if within_deadline now received (ttl_ms sent) then
    match dt_ms sent with
    | Some dt =>
        if negb (Nat.eqb (steps sent) 0) && is_duration dt then
          let tick := floor_index (div (age_ms now received) dt) (steps sent + 1) in
          if Nat.ltb (steps sent) tick then None else Some tick
        else Some 0%nat
    | None => Some 0%nat
    end
  else None.
Proof.
  intros sent received q now. unfold plays, active, should_hold.
  change (deadline (Plant (Some q) (Some (received, ttl_ms sent)) false)) with (Some (received, ttl_ms sent)).
  cbv iota beta zeta. case (within_deadline now received (ttl_ms sent)); [|reflexivity].
  cbv iota beta zeta delta [orb stopped deadline].
  case (dt_ms sent); [|reflexivity]. intros dt. case (negb (Nat.eqb (steps sent) 0) && is_duration dt); [|reflexivity].
  case (Nat.ltb _ _); reflexivity.
Qed.

Lemma plays_within : forall sent received q now k, plays sent received q now = Some k ->
  within_deadline now received (ttl_ms sent) = true.
Proof.
  intros sent received q now k H. rewrite plays_case in H.
  destruct (within_deadline now received (ttl_ms sent)) eqn:W; [reflexivity|discriminate].
Qed.

Lemma plays_first : forall sent received q now k, plays sent received q now = Some k ->
  steps sent = 0%nat -> k = 0%nat.
Proof.
  intros sent received q now k H S. rewrite plays_case, S in H.
  destruct (within_deadline now received (ttl_ms sent)) eqn:W; [|discriminate].
  destruct (dt_ms sent) as [dt|]; [|congruence]. change (negb (0 =? 0)%nat) with false in H. cbv iota beta delta [andb] in H.
  congruence.
Qed.

Lemma plays_tick : forall sent received q now k dt, plays sent received q now = Some k ->
  (0 < steps sent)%nat -> dt_ms sent = Some dt -> is_duration dt = true ->
  k = floor_index (div (age_ms now received) dt) (steps sent + 1) /\ (k <= steps sent)%nat.
Proof.
  intros sent received q now k dt H S D T. rewrite plays_case, D, T in H.
  destruct (within_deadline now received (ttl_ms sent)) eqn:W; [|discriminate].
  destruct (Nat.eqb_spec (steps sent) 0) as [E|_]; [lia|]. cbv zeta beta iota delta [negb andb] in H.
  destruct (Nat.ltb_spec (steps sent) (floor_index (div (age_ms now received) dt) (steps sent + 1))); [discriminate|].
  injection H as <-. auto.
Qed.

(** What is played is of the age's tick, but near the change of ticks; and nothing is played after the deadline. *)
Theorem plays_exact : forall sent received q now k dt age kappa,
  plays sent received q now = Some k -> (0 < steps sent)%nat -> (Z.of_nat (steps sent) < 2 ^ 53)%Z ->
  dt_ms sent = Some dt -> is_duration dt = true ->
  Rabs (exact_age now received - age) <= kappa ->
  let t := val (enforced sent) in
  (k <= steps sent)%nat /\ age < t + slack t kappa /\
  (forall j, (j <= steps sent + 1)%nat -> INR j * val dt + slack t kappa <= age -> (j <= k)%nat) /\
  (forall j, (j <= steps sent)%nat -> age < INR (Datatypes.S j) * val dt - slack t kappa -> (k <= j)%nat).
Proof.
  intros sent received q now k dt age kappa H S S53 D T C t.
  pose proof (plays_within _ _ _ _ _ H) as W. apply within_exact in W. cbv zeta in W. fold t in W.
  destruct W as (Fn & Fr & Hr & Fa & (A0 & A1) & A2).
  destruct (plays_tick _ _ _ _ _ _ H S D T) as (K & K1).
  assert (Fd : finite dt = true /\ 0 < val dt).
  { unfold is_duration in T. apply andb_prop in T as (F & P). destruct zero_val as (Fz & Z).
    apply (lt_val zero _ Fz F) in P. rewrite Z in P. auto. }
  destruct Fd as (Fd & Pd).
  destruct (quotient (age_ms now received) dt Fa Fd A0 Pd) as (Q0 & Q1).
  set (x := div (age_ms now received) dt) in *. set (a := val (age_ms now received)) in *.
  pose proof u_small as (U & U'). pose proof tiny_pos as P. pose proof tiny_slack as TS. pose proof delta_pos as DP.
  apply Rabs_le_inv in A2. apply Rabs_le_inv in C.
  assert (Ut : 0 <= u * t) by (apply Rmult_le_pos; lra).
  unfold slack. split; [exact K1|]. split; [lra|]. split.
  - intros j Hj L. destruct (Nat.le_gt_cases j k) as [|G]; [assumption|exfalso].
    rewrite K in G. destruct (index_lt x j (steps sent + 1) G Hj Q0) as (X & Fx). rewrite Fx in Q1.
    assert (B : INR j <= a / val dt).
    { apply Rmult_le_reg_r with (val dt); [exact Pd|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    apply rnd_le in B. rewrite rnd_INR in B by lia. lra.
  - intros j Hj L. destruct (Nat.le_gt_cases k j) as [|G]; [assumption|exfalso].
    assert (G' : (Datatypes.S j <= floor_index x (steps sent + 1))%nat) by lia.
    set (m := INR (Datatypes.S j)) in *.
    assert (M : 1 <= m). { unfold m. rewrite S_INR. pose proof (pos_INR j). lra. }
    assert (R1 : m <= rnd (a / val dt)).
    { apply index_ge in G'; [|lia]. fold m in G'. destruct (finite x).
      - rewrite <- Q1. destruct G' as [|G']; [discriminate|exact G'].
      - apply Rle_trans with (bpow radix2 1024); [|exact Q1].
        apply Rle_trans with (IZR (2 ^ 53)).
        + unfold m. rewrite INR_IZR_INZ. apply IZR_le. lia.
        + change (IZR (2 ^ 53)) with (IZR (radix2 ^ 53)). rewrite IZR_Zpower by lia. apply bpow_le. lia. }
    assert (B : a * (1 + 4 * u) <= m * val dt).
    { assert (u * a <= u * t) by (apply Rmult_le_compat_l; lra). lra. }
    assert (Y0 : 0 <= a / val dt).
    { unfold Rdiv. apply Rmult_le_pos; [exact A0|]. apply Rlt_le, Rinv_0_lt_compat, Pd. }
    assert (Y : a / val dt <= m * (1 - 2 * u)).
    { apply Rmult_le_reg_r with (val dt); [exact Pd|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
      assert (a * (1 + 4 * u) * (1 - 2 * u) <= m * val dt * (1 - 2 * u)) by (apply Rmult_le_compat_r; lra).
      assert (1 <= (1 + 4 * u) * (1 - 2 * u)) by nra.
      assert (a * 1 <= a * ((1 + 4 * u) * (1 - 2 * u))) by (apply Rmult_le_compat_l; lra). lra. }
    pose proof (rnd_error (a / val dt)) as E. rewrite (Rabs_right _ (Rle_ge _ _ Y0)) in E. apply Rabs_le_inv in E.
    set (y := a / val dt) in *.
    assert (y * (1 + u) <= m * (1 - 2 * u) * (1 + u)) by (apply Rmult_le_compat_r; lra).
    assert (m * (1 - 2 * u) * (1 + u) <= m * (1 - u)).
    { rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|]. nra. }
    assert (u <= m * u) by nra.
    assert (tiny < u) by (unfold tiny, u; apply bpow_lt; lia). lra.
Qed.

End Plant.
