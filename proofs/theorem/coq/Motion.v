(** A plant that follows one governed command: it stays within the ball until its watchdog holds it. *)

From Coq Require Import ZArith Reals Psatz Bool Arith.
From Flocq Require Import Core BinarySingleNaN.
From NCP Require Import Kernel Doubles Ball Inside Step Horizon Clock.

Open Scope R_scope.

Lemma moved_moved : forall p v s t, moved (moved p v s) v t = moved p v (s + t).
Proof. intros ((x, y), z) ((a, b), c) s t. simpl. f_equal; [f_equal|]; field. Qed.

(** The first tick whose end is not before an age. *)
Lemma tick_of : forall (dt age : R) (n : nat), 0 <= age <= INR (Datatypes.S n) * dt ->
  exists k, (k <= n)%nat /\ INR k * dt <= age <= INR (Datatypes.S k) * dt.
Proof.
  intros dt age n. induction n as [|n IH]; intros H.
  - exists 0%nat. simpl INR in *. split; [lia|lra].
  - destruct (Rle_lt_dec age (INR (Datatypes.S n) * dt)) as [L|L].
    + destruct IH as (k & K & A); [lra|]. exists k. split; [lia|exact A].
    + exists (Datatypes.S n). split; [lia|lra].
Qed.

(** ** The hypotheses *)

(** A plant that follows one command, with what is assumed of it and of the world. All times are true ages of the
    command in ms: 0 is the moment of its receipt. [kappa] bounds how far the plant's clock is off in reading that age,
    by its resolution too. *)
Record following {Q : Sequence} (sent : plan doubles) (measured : vec doubles) (received : num doubles) (q : seq Q)
    (speed kappa : R) (clock : R -> num doubles) (position : R -> point) (held : R) : Prop := {
  (** At the receipt the plant is where the governor took it to be: the position is current, no time is lost on the way. *)
  position_current : position 0 = place measured;
  (** What the clock reads until the plant holds. *)
  clock_within : forall age, 0 <= age <= held -> Rabs (exact_age (clock age) received - age) <= kappa;
  (** From [held] on, and no sooner, the plant holds by its own decision. *)
  held_after_receipt : 0 <= held;
  plays_until_held : forall age, 0 <= age < held -> plays sent received q (clock age) <> None;
  rests_when_held : forall age, held <= age -> position age = position held;
  (** While one tick is played, the plant moves with the velocity of the tick. *)
  follows_exactly : forall a b k, 0 <= a <= b -> b <= held ->
    (forall age, a <= age < b -> plays sent received q (clock age) = Some k) ->
    position b = moved (position a) (velocity_of sent k) (b - a);
  (** It never moves faster, in any component, than the fastest velocity of the command. *)
  never_faster : forall a b, 0 <= a <= b -> b <= held -> near (position a) (position b) (speed * (b - a) / 1000) }.

Section Motion.
Context {Q : Sequence}.
Variables (sent : plan doubles) (measured : vec doubles) (received radius : num doubles) (q : seq Q).
Variables (speed kappa : R) (clock : R -> num doubles) (position : R -> point) (held : R).
Hypothesis F : following sent measured received q speed kappa clock position held.
Hypothesis Hspeed : 0 <= speed.
Hypothesis Hin : inside measured radius = true.
Hypothesis Hslow : forall k, (k <= steps sent)%nat -> slow (velocity_of sent k) speed.

Let t := val (enforced sent).
Let theta := slack t kappa.
Let drift := speed * theta / 1000.
Let b := val radius * (1 + 3 * u) + delta.

Lemma kappa_nonneg : 0 <= kappa.
Proof.
  pose proof (held_after_receipt _ _ _ _ _ _ _ _ _ F) as H.
  pose proof (clock_within _ _ _ _ _ _ _ _ _ F 0 (conj (Rle_refl 0) H)) as C.
  pose proof (Rabs_pos (exact_age (clock 0) received - 0)). lra.
Qed.

Lemma t_bounds : 0 <= t <= 60000.
Proof. apply enforced_val. Qed.

Lemma theta_pos : 0 < theta.
Proof.
  pose proof kappa_nonneg. pose proof u_pos. pose proof delta_pos. pose proof t_bounds.
  assert (0 <= u * t) by (apply Rmult_le_pos; lra). unfold theta, slack. lra.
Qed.

Lemma drift_nonneg : 0 <= drift.
Proof.
  pose proof theta_pos. unfold drift. assert (0 <= speed * theta) by (apply Rmult_le_pos; lra). lra.
Qed.

(** What moves for less than [theta] moves for less than [drift]. *)
Lemma drift_le : forall s, 0 <= s <= theta -> speed * s / 1000 <= drift.
Proof. intros s H. unfold drift. assert (speed * s <= speed * theta) by (apply Rmult_le_compat_l; lra). lra. Qed.

Lemma slow_for : forall k p s, (k <= steps sent)%nat -> 0 <= s <= theta ->
  near p (moved p (velocity_of sent k) s) drift.
Proof.
  intros k p s Hk Hs. eapply near_le; [apply slow_moved; [now apply Hslow|lra]|]. now apply drift_le.
Qed.

Lemma position_for : forall a c, 0 <= a <= c -> c <= held -> c - a <= theta -> near (position a) (position c) drift.
Proof.
  intros a c H1 H2 H3. eapply near_le; [apply (never_faster _ _ _ _ _ _ _ _ _ F); assumption|]. apply drift_le. lra.
Qed.

Lemma start_inside : far (position 0) <= b.
Proof. rewrite (position_current _ _ _ _ _ _ _ _ _ F). now apply (inside_exact measured radius). Qed.

(** *** Without a horizon *)

Lemma held_by_ttl : held <= t + theta.
Proof.
  destruct (Rle_lt_dec held (t + theta)) as [|H]; [assumption|exfalso].
  pose proof t_bounds. pose proof theta_pos.
  assert (P : 0 <= t + theta < held) by lra.
  pose proof (plays_until_held _ _ _ _ _ _ _ _ _ F _ P) as N.
  destruct (plays sent received q (clock (t + theta))) as [k|] eqn:E; [|congruence].
  apply plays_within in E. apply within_exact in E. cbv zeta in E. fold t in E.
  destruct E as (_ & _ & _ & _ & A & D). pose proof (clock_within _ _ _ _ _ _ _ _ _ F (t + theta) ltac:(lra)) as C.
  apply Rabs_le_inv in D. apply Rabs_le_inv in C.
  pose proof u_pos. pose proof tiny_slack. pose proof delta_pos. pose proof tiny_pos.
  assert (0 <= u * t) by (apply Rmult_le_pos; lra).
  unfold theta, slack in *. lra.
Qed.

Lemma alone_within : steps sent = 0%nat -> steps_inside sent measured radius = Ok 0%nat ->
  forall age, 0 <= age -> far (position age) <= b + 2 * (step_error (val radius) speed t + drift).
Proof.
  intros S0 Hs. pose proof (alone_exact sent measured radius speed Hs (Hslow 0 (Nat.le_0_l _))) as E.
  cbv zeta in E. fold t b in E. pose proof t_bounds as T. pose proof drift_nonneg as D.
  assert (R0 : 0 < val radius) by now apply (inside_exact measured).
  pose proof (step_error_nonneg (val radius) speed t ltac:(lra) Hspeed (proj1 T)) as SE.
  assert (First : forall age, 0 <= age <= held -> position age = moved (place measured) (velocity_of sent 0) age).
  { intros age Ha. rewrite (follows_exactly _ _ _ _ _ _ _ _ _ F 0 age 0%nat); [|lra|lra|].
    - rewrite (position_current _ _ _ _ _ _ _ _ _ F). f_equal. ring.
    - intros s Hs'. pose proof (plays_until_held _ _ _ _ _ _ _ _ _ F s ltac:(lra)) as N.
      destruct (plays sent received q (clock s)) as [k|] eqn:P; [|now elim N].
      now rewrite (plays_first _ _ _ _ _ P S0). }
  assert (Before : forall age, 0 <= age <= held -> age <= t -> far (position age) <= b + 2 * step_error (val radius) speed t).
  { intros age Ha Ht. pose proof start_inside as I.
    destruct (Req_dec age 0) as [->|Z]; [lra|].
    rewrite First, (moved_between _ _ _ t) by lra. apply ball_convex.
    - split; [apply Rlt_le, Rdiv_lt_0_compat; lra|]. apply Rmult_le_reg_r with t; [lra|]. unfold Rdiv.
      rewrite Rmult_assoc, Rinv_l by lra. lra.
    - rewrite (position_current _ _ _ _ _ _ _ _ _ F) in I. lra.
    - exact E. }
  assert (Until : forall age, 0 <= age <= held -> far (position age) <= b + 2 * (step_error (val radius) speed t + drift)).
  { intros age Ha. destruct (Rle_lt_dec age t) as [L|L]; [pose proof (Before age Ha L); lra|].
    pose proof held_by_ttl as H. pose proof (Before t ltac:(lra) ltac:(lra)) as Bt.
    replace (b + 2 * (step_error (val radius) speed t + drift)) with (b + 2 * step_error (val radius) speed t + 2 * drift) by ring.
    apply far_near with (position t); [exact Bt|]. apply position_for; lra. }
  intros age Ha. destruct (Rle_lt_dec age held) as [L|L]; [now apply Until|].
  rewrite (rests_when_held _ _ _ _ _ _ _ _ _ F) by lra.
  pose proof (held_after_receipt _ _ _ _ _ _ _ _ _ F). apply Until. lra.
Qed.

(** *** With a horizon *)

Section Steps.
Variable dt : num doubles.
Hypothesis Hn : (0 < steps sent)%nat.
Hypothesis Hn53 : (Z.of_nat (steps sent) < 2 ^ 53)%Z.
Hypothesis Hdt : dt_ms sent = Some dt.
Hypothesis Hd : is_duration dt = true.
Let n := steps sent.
Let d := val dt.

Lemma dt_pos : 0 < d.
Proof.
  unfold is_duration in Hd. apply andb_prop in Hd as (Fd & P). destruct zero_val as (Fz & Z).
  apply (lt_val zero _ Fz Fd) in P. rewrite Z in P. exact P.
Qed.

Lemma played : forall age, 0 <= age < held -> exists k, plays sent received q (clock age) = Some k /\ (k <= n)%nat /\
  (forall j, (j <= n + 1)%nat -> INR j * d + theta <= age -> (j <= k)%nat) /\
  (forall j, (j <= n)%nat -> age < INR (Datatypes.S j) * d - theta -> (k <= j)%nat).
Proof.
  intros age H. pose proof (plays_until_held _ _ _ _ _ _ _ _ _ F age H) as N.
  destruct (plays sent received q (clock age)) as [k|] eqn:E; [|congruence]. exists k. split; [reflexivity|].
  destruct (plays_exact sent received q (clock age) k dt age kappa E Hn Hn53 Hdt Hd
    (clock_within _ _ _ _ _ _ _ _ _ F age ltac:(lra))) as (A & _ & B & C). auto.
Qed.

Lemma held_by_horizon : held <= INR (Datatypes.S n) * d + theta.
Proof.
  destruct (Rle_lt_dec held (INR (Datatypes.S n) * d + theta)) as [|H]; [assumption|exfalso].
  pose proof dt_pos. pose proof theta_pos. pose proof (pos_INR (Datatypes.S n)).
  assert (0 <= INR (Datatypes.S n) * d) by (apply Rmult_le_pos; lra).
  destruct (played (INR (Datatypes.S n) * d + theta) ltac:(lra)) as (k & _ & K & A & _).
  specialize (A (Datatypes.S n) ltac:(lia) ltac:(lra)). lia.
Qed.

(** Within one tick. *)
Lemma tick_near : forall k age, (k <= n)%nat -> INR k * d <= age <= INR (Datatypes.S k) * d -> age <= held ->
  near (moved (position (INR k * d)) (velocity_of sent k) (age - INR k * d)) (position age) (4 * drift).
Proof.
  intros k age Hk (H0 & H1) Hh. pose proof dt_pos as Pd. pose proof theta_pos as Pt. pose proof drift_nonneg as D0.
  pose proof (pos_INR k) as Pk. assert (S0 : 0 <= INR k * d) by (apply Rmult_le_pos; lra).
  set (s := INR k * d) in *. set (e := INR (Datatypes.S k) * d) in *. set (v := velocity_of sent k).
  set (m1 := Rmin age (s + theta)). set (m2 := Rmax m1 (Rmin age (e - theta))).
  assert (M : s <= m1 <= s + theta /\ m1 <= m2 <= age /\ age - m2 <= theta).
  { unfold m2, m1, Rmax, Rmin. destruct (Rle_dec age (s + theta)), (Rle_dec age (e - theta));
      repeat match goal with |- context [Rle_dec ?a ?c] => destruct (Rle_dec a c) end; lra. }
  destruct M as (M1 & M2 & M3).
  assert (Follow : position m2 = moved (position m1) v (m2 - m1)).
  { apply (follows_exactly _ _ _ _ _ _ _ _ _ F); [lra|lra|]. intros c Hc.
    assert (C : s + theta <= c < e - theta).
    { revert Hc. unfold m2, m1, Rmax, Rmin. destruct (Rle_dec age (s + theta)), (Rle_dec age (e - theta));
        repeat match goal with |- context [Rle_dec ?a ?c] => destruct (Rle_dec a c) end; lra. }
    destruct (played c ltac:(lra)) as (j & -> & J & A & B).
    specialize (A k ltac:(lia)). specialize (B k Hk). fold s in A. fold e in B.
    specialize (A ltac:(lra)). specialize (B ltac:(lra)). f_equal. lia. }
  replace (4 * drift) with ((drift + drift) + (drift + drift)) by ring.
  (* The exact plant first misses what is left of the tick, then moves apart from the start by no more than twice. *)
  apply near_trans with (moved (position s) v (m2 - m1)).
  - apply near_sym. apply near_trans with (moved (position s) v (m2 - m1 + (m1 - s))).
    + rewrite <- moved_moved. apply slow_for; [exact Hk|lra].
    + replace (age - s) with (m2 - m1 + (m1 - s) + (age - m2)) by ring. rewrite <- (moved_moved _ _ (m2 - m1 + (m1 - s))).
      apply slow_for; [exact Hk|lra].
  - apply near_trans with (position m2).
    + rewrite Follow. apply moved_near. apply position_for; lra.
    + apply position_for; lra.
Qed.

Lemma start_near : forall k, (k <= Datatypes.S n)%nat -> INR k * d <= t -> INR k * d <= held ->
  near (start_of sent (place measured) d t k) (position (INR k * d)) (INR k * (4 * drift)).
Proof.
  pose proof dt_pos as Pd. pose proof drift_nonneg as D0.
  induction k as [|k IH]; intros Hk Ht Hh.
  - simpl INR in *. rewrite !Rmult_0_l. rewrite (position_current _ _ _ _ _ _ _ _ _ F). apply near_refl. lra.
  - assert (K : INR k * d <= INR (Datatypes.S k) * d) by (rewrite S_INR; lra).
    specialize (IH ltac:(lia) ltac:(lra) ltac:(lra)). cbn [start_of].
    assert (Sh : share k d t = INR (Datatypes.S k) * d - INR k * d).
    { rewrite S_INR in *. unfold share. rewrite Rmin_left by lra. rewrite Rmax_right by lra. ring. }
    rewrite Sh. rewrite (S_INR k) at 3.
    replace ((INR k + 1) * (4 * drift)) with (INR k * (4 * drift) + 4 * drift) by ring.
    eapply near_trans; [apply moved_near; exact IH|]. apply tick_near; [lia|lra|lra].
Qed.

Lemma horizon_within : steps_inside sent measured radius = Ok n ->
  forall age, 0 <= age -> far (position age) <= b + 2 * (INR (Datatypes.S n) * (step_error (val radius) speed t + 4 * drift) + drift).
Proof.
  intros Hs.
  destruct (horizon_exact sent measured dt radius speed n Hin Hs Hn Hdt Hd ltac:(fold n; lia) Hslow) as (_ & E).
  fold t b d in E. pose proof t_bounds as T. pose proof drift_nonneg as D. pose proof dt_pos as Pd.
  assert (R0 : 0 < val radius) by now apply (inside_exact measured).
  pose proof (step_error_nonneg (val radius) speed t ltac:(lra) Hspeed (proj1 T)) as SE.
  set (err := step_error (val radius) speed t) in *. set (N := INR (Datatypes.S n)) in *.
  assert (N1 : 1 <= N) by (unfold N; rewrite S_INR; pose proof (pos_INR n); lra).
  assert (Before : forall age, 0 <= age <= held -> age <= t -> age <= N * d ->
    far (position age) <= b + 2 * (N * (err + 4 * drift))).
  { intros age Ha Ht Hnd. destruct (tick_of d age n ltac:(fold N; lra)) as (k & Hk & Hka).
    assert (Kn : INR (Datatypes.S k) <= N) by (apply le_INR; lia).
    assert (Kn0 : INR k <= N) by (apply le_INR; lia).
    assert (X : far (moved (start_of sent (place measured) d t k) (velocity_of sent k) (age - INR k * d)) <= b + 2 * (N * err)).
    { apply way_exact; try assumption.
      - eapply Rle_trans; [apply E; lia|]. assert (INR k * err <= N * err) by (apply Rmult_le_compat_r; lra). lra.
      - eapply Rle_trans; [apply E; lia|]. assert (INR (Datatypes.S k) * err <= N * err) by (apply Rmult_le_compat_r; lra). lra. }
    replace (b + 2 * (N * (err + 4 * drift))) with (b + 2 * (N * err) + 2 * (N * (4 * drift))) by ring.
    eapply far_near; [exact X|].
    apply near_le with (INR k * (4 * drift) + 4 * drift).
    - eapply near_trans; [apply moved_near; apply start_near; [lia|lra|lra]|]. apply tick_near; [exact Hk|exact Hka|lra].
    - rewrite S_INR in Kn. assert ((INR k + 1) * (4 * drift) <= N * (4 * drift)) by (apply Rmult_le_compat_r; lra). lra. }
  assert (Until : forall age, 0 <= age <= held -> far (position age) <= b + 2 * (N * (err + 4 * drift) + drift)).
  { intros age Ha. set (last := Rmin t (N * d)).
    assert (L0 : 0 <= last) by (unfold last; apply Rmin_glb; [lra|apply Rmult_le_pos; lra]).
    assert (L1 : last <= t) by apply Rmin_l. assert (L2 : last <= N * d) by apply Rmin_r.
    assert (L3 : held - last <= theta).
    { pose proof held_by_ttl. pose proof held_by_horizon. fold N in H0. unfold last, Rmin. destruct Rle_dec; lra. }
    destruct (Rle_lt_dec age last) as [L|L].
    - pose proof (Before age Ha ltac:(lra) ltac:(lra)). lra.
    - pose proof (Before last ltac:(lra) L1 L2) as Bl.
      replace (b + 2 * (N * (err + 4 * drift) + drift)) with (b + 2 * (N * (err + 4 * drift)) + 2 * drift) by ring.
      apply far_near with (position last); [exact Bl|]. apply position_for; lra. }
  intros age Ha. destruct (Rle_lt_dec age held) as [L|L]; [now apply Until|].
  rewrite (rests_when_held _ _ _ _ _ _ _ _ _ F) by lra.
  pose proof (held_after_receipt _ _ _ _ _ _ _ _ _ F). apply Until. lra.
Qed.

End Steps.

(** How far out of the ball of the radius a plant may get. *)
Definition excursion (r v ticks ttl off : R) : R :=
  3 * u * r + delta + 2 * (ticks * (step_error r v ttl + 4 * (v * slack ttl off / 1000)) + v * slack ttl off / 1000).

Theorem within : steps_inside sent measured radius = Ok (steps sent) -> (Z.of_nat (steps sent) < 2 ^ 53)%Z ->
  (steps sent <> 0%nat -> exists dt, dt_ms sent = Some dt /\ is_duration dt = true) ->
  forall age, 0 <= age ->
  far (position age) <= val radius + excursion (val radius) speed (INR (Datatypes.S (steps sent))) t kappa.
Proof.
  intros Hs H53 Hdt age Ha. unfold excursion. fold theta drift.
  assert (Eb : val radius * (1 + 3 * u) + delta = b) by reflexivity.
  destruct (Nat.eq_dec (steps sent) 0) as [Z|Z].
  - rewrite Z in Hs. pose proof (alone_within Z Hs age Ha) as A. rewrite Z. simpl INR.
    pose proof drift_nonneg. lra.
  - destruct (Hdt Z) as (dt & D1 & D2).
    pose proof (horizon_within dt ltac:(lia) H53 D1 D2 Hs age Ha) as A. lra.
Qed.

End Motion.
