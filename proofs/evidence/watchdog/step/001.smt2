; watchdog/step: init = model.init; ∀ σ ∈ (I64 ∪ {none}) × (F64² ∪ {none}), events e: step(σ, e) = model.step(σ, e), answer and every member of the state, bit by bit
; Each answer has to be unsat, 22 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const q0 (_ BitVec 64))
(define-fun t5 () Bool (= q0 (_ bv0 64)))
(declare-const x2 Float64)
(define-fun t9 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t11 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x1))
(define-fun t13 () Bool (fp.lt x1 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t14 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t15 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t16 () Bool (fp.leq x0 x2))
(define-fun t17 () Float64 (fp.sub RNE x2 x0))
(define-fun t19 () Float64 (fp.mul RNE t17 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t20 () Bool (fp.leq t19 x1))
(define-fun t21 () Bool (and t9 t11))
(define-fun t22 () Bool (fp.leq t19 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t23 () Bool (and t14 t15))
(define-fun t24 () Bool (and t16 t23))
(define-fun t25 () Bool (and t21 t24))
(define-fun t26 () Bool (and t20 t25))
(define-fun t27 () Bool (and t22 t26))
(declare-const q1 (_ BitVec 64))
(define-fun t30 () Bool (bvslt q0 q1))
(define-fun t32 () Bool (= q1 (_ bv0 64)))
(define-fun t33 () Bool (bvslt q1 q0))
(define-fun t36 () Bool (and t33 (not t32)))
(define-fun t38 () Bool (and t30 (not t32)))
(define-fun t39 () Bool (= q0 q1))
(define-fun t40 () Bool (and t38 t39))
(define-fun t43 () Bool (and t38 (not t40)))
(define-fun t45 () Bool (= q1 q0))
(define-fun t46 () Bool (and (not t38) t45))
(define-fun t48 () Bool (and (not t38) (not t46)))
(push 1) ; a HOLD is never ignored
(assert (not t32))(assert t33)(assert (not t36))
(check-sat)
(pop 1)
(push 1) ; a HOLD is never ignored
(assert (not t32))(assert (not t33))(assert (not (not t36)))
(check-sat)
(pop 1)
(push 1) ; a HOLD is never ignored
(assert t32)(assert (not (not t36)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert t5)(assert (not t5))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert (not t5))(assert (not (not t5)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert (not t30))(assert (not t32))(assert (not (not t43)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert (not t30))(assert t32)(assert (not (not t43)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert t30)(assert t32)(assert (not (not t43)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert t30)(assert (not t32))(assert (not (not t48)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t9)(assert t11)(assert (not t13))(assert t14)(assert t15)(assert t16)(assert t22)(assert (not t27))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t9)(assert t11)(assert (not t13))(assert t14)(assert t15)(assert t16)(assert t22)(assert (not t27))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t9)(assert t11)(assert t13)(assert t14)(assert t15)(assert t16)(assert t20)(assert (not t27))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t9)(assert t11)(assert t13)(assert t14)(assert t15)(assert t16)(assert t20)(assert (not t27))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert (not t9))(assert (not (not t27)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t9)(assert (not t11))(assert (not (not t27)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t9)(assert t11)(assert (not t14))(assert (not (not t27)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t9)(assert t11)(assert t14)(assert (not t15))(assert (not (not t27)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t9)(assert t11)(assert t14)(assert t15)(assert (not t16))(assert (not (not t27)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t9)(assert t11)(assert t14)(assert t15)(assert t16)(assert (not t20))(assert (not (not t27)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive
(assert t9)(assert t11)(assert t14)(assert t15)(assert t16)(assert (not t22))(assert (not (not t27)))
(check-sat)
(pop 1)
(push 1) ; only an advancing command refreshes
(assert t30)(assert (not t30))
(check-sat)
(pop 1)
(push 1) ; only an advancing command refreshes
(assert (not t30))(assert (not (not t30)))
(check-sat)
(pop 1)
