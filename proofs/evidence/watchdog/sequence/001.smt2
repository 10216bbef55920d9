; watchdog/sequence: ∀ sequences of command, hold, reading and reset: ¬should_hold(now) ⇒ ∃ i: alive(now, rᵢ, ttlᵢ) ∧ (∀ j < i: sⱼ < sᵢ) ∧ (∀ j > i: sⱼ ≤ sᵢ) ∧ nothing held since i, all after the last reset
; Each answer has to be unsat, 288 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const q0 (_ BitVec 64))
(declare-const x2 Float64)
(declare-const x3 Float64)
(declare-const q1 (_ BitVec 64))
(define-fun t6 () Bool (bvslt q0 q1))
(declare-const x4 Float64)
(declare-const x5 Float64)
(declare-const q2 (_ BitVec 64))
(define-fun t10 () Bool (bvslt q1 q2))
(declare-const x6 Float64)
(define-fun t15 () Bool (not (or (fp.isNaN x5) (fp.isInfinite x5))))
(define-fun t17 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x5))
(define-fun t19 () Bool (fp.lt x5 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t20 () Bool (not (or (fp.isNaN x6) (fp.isInfinite x6))))
(define-fun t21 () Bool (not (or (fp.isNaN x4) (fp.isInfinite x4))))
(define-fun t22 () Bool (fp.leq x4 x6))
(define-fun t23 () Float64 (fp.sub RNE x6 x4))
(define-fun t25 () Float64 (fp.mul RNE t23 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t26 () Bool (fp.leq t25 x5))
(define-fun t29 () Float64 (fp.sub RNE x6 x0))
(define-fun t30 () Float64 (fp.mul RNE t29 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t31 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t32 () Bool (fp.leq x0 x6))
(define-fun t33 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t34 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x1))
(define-fun t35 () Bool (and t33 t34))
(define-fun t36 () Bool (fp.leq t30 x1))
(define-fun t37 () Bool (fp.leq t30 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t38 () Bool (and t20 t31))
(define-fun t39 () Bool (and t32 t38))
(define-fun t40 () Bool (and t35 t39))
(define-fun t41 () Bool (and t36 t40))
(define-fun t42 () Bool (and t37 t41))
(define-fun t44 () Bool (and t42 (not t6)))
(define-fun t45 () Bool (bvslt q0 q2))
(define-fun t47 () Bool (and t44 (not t45)))
(define-fun t49 () Float64 (fp.sub RNE x6 x2))
(define-fun t50 () Float64 (fp.mul RNE t49 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t51 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t52 () Bool (fp.leq x2 x6))
(define-fun t53 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t54 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x3))
(define-fun t55 () Bool (and t53 t54))
(define-fun t56 () Bool (fp.leq t50 x3))
(define-fun t57 () Bool (fp.leq t50 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t58 () Bool (and t20 t51))
(define-fun t59 () Bool (and t52 t58))
(define-fun t60 () Bool (and t55 t59))
(define-fun t61 () Bool (and t56 t60))
(define-fun t62 () Bool (and t57 t61))
(define-fun t63 () Bool (and t6 t62))
(define-fun t65 () Bool (and t63 (not t10)))
(define-fun t67 () Bool (and (not t47) (not t65)))
(define-fun t69 () Bool (and t15 t17))
(define-fun t70 () Bool (fp.leq t25 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t71 () Bool (and t20 t21))
(define-fun t72 () Bool (and t22 t71))
(define-fun t73 () Bool (and t69 t72))
(define-fun t74 () Bool (and t26 t73))
(define-fun t75 () Bool (and t70 t74))
(define-fun t76 () Bool (and t45 t75))
(define-fun t77 () Bool (and t10 t76))
(define-fun t79 () Bool (and t67 (not t77)))
(define-fun t82 () Bool (fp.lt x3 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t83 () Bool (fp.leq x2 x4))
(define-fun t84 () Float64 (fp.sub RNE x4 x2))
(define-fun t85 () Float64 (fp.mul RNE t84 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t86 () Bool (fp.leq t85 x3))
(define-fun t87 () Float64 (fp.sub RNE x4 x0))
(define-fun t88 () Float64 (fp.mul RNE t87 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t89 () Bool (fp.leq x0 x4))
(define-fun t90 () Bool (fp.leq t88 x1))
(define-fun t91 () Bool (fp.leq t88 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t92 () Bool (and t21 t31))
(define-fun t93 () Bool (and t89 t92))
(define-fun t94 () Bool (and t35 t93))
(define-fun t95 () Bool (and t90 t94))
(define-fun t96 () Bool (and t91 t95))
(define-fun t97 () Bool (and (not t6) t96))
(define-fun t99 () Bool (fp.leq t85 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t100 () Bool (and t21 t51))
(define-fun t101 () Bool (and t83 t100))
(define-fun t102 () Bool (and t55 t101))
(define-fun t103 () Bool (and t86 t102))
(define-fun t104 () Bool (and t99 t103))
(define-fun t105 () Bool (and t6 t104))
(define-fun t107 () Bool (and (not t97) (not t105)))
(define-fun t109 () Bool (fp.leq x2 x5))
(define-fun t110 () Float64 (fp.sub RNE x5 x2))
(define-fun t111 () Float64 (fp.mul RNE t110 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t112 () Bool (fp.leq t111 x3))
(define-fun t113 () Float64 (fp.sub RNE x5 x0))
(define-fun t114 () Float64 (fp.mul RNE t113 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t115 () Bool (fp.leq x0 x5))
(define-fun t116 () Bool (fp.leq t114 x1))
(define-fun t117 () Bool (fp.leq t114 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t118 () Bool (and t15 t31))
(define-fun t119 () Bool (and t115 t118))
(define-fun t120 () Bool (and t35 t119))
(define-fun t121 () Bool (and t116 t120))
(define-fun t122 () Bool (and t117 t121))
(define-fun t123 () Bool (and (not t6) t122))
(define-fun t125 () Bool (fp.leq t111 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t126 () Bool (and t15 t51))
(define-fun t127 () Bool (and t109 t126))
(define-fun t128 () Bool (and t55 t127))
(define-fun t129 () Bool (and t112 t128))
(define-fun t130 () Bool (and t125 t129))
(define-fun t131 () Bool (and t6 t130))
(define-fun t133 () Bool (and (not t123) (not t131)))
(define-fun t136 () Bool (fp.lt x1 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t137 () Bool (fp.leq x0 x2))
(define-fun t138 () Float64 (fp.sub RNE x2 x0))
(define-fun t139 () Float64 (fp.mul RNE t138 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t140 () Bool (fp.leq t139 x1))
(define-fun t141 () Bool (fp.leq t139 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t142 () Bool (and t31 t51))
(define-fun t143 () Bool (and t137 t142))
(define-fun t144 () Bool (and t35 t143))
(define-fun t145 () Bool (and t140 t144))
(define-fun t146 () Bool (and t141 t145))
(define-fun t148 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x4))
(define-fun t149 () Bool (fp.lt x4 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t150 () Bool (fp.leq x3 x5))
(define-fun t151 () Float64 (fp.sub RNE x5 x3))
(define-fun t152 () Float64 (fp.mul RNE t151 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t153 () Bool (fp.leq t152 x4))
(define-fun t154 () Bool (and t21 t148))
(define-fun t155 () Bool (fp.leq t152 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t156 () Bool (and t15 t53))
(define-fun t157 () Bool (and t150 t156))
(define-fun t158 () Bool (and t154 t157))
(define-fun t159 () Bool (and t153 t158))
(define-fun t160 () Bool (and t155 t159))
(define-fun t161 () Bool (and t6 t160))
(define-fun t163 () Bool (and (not t123) (not t161)))
(define-fun t165 () Bool (fp.leq x0 x3))
(define-fun t166 () Float64 (fp.sub RNE x3 x0))
(define-fun t167 () Float64 (fp.mul RNE t166 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t168 () Bool (fp.leq t167 x1))
(define-fun t169 () Bool (fp.leq t167 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t170 () Bool (and t31 t53))
(define-fun t171 () Bool (and t165 t170))
(define-fun t172 () Bool (and t35 t171))
(define-fun t173 () Bool (and t168 t172))
(define-fun t174 () Bool (and t169 t173))
(define-fun t178 () Float64 (fp.sub RNE x5 x1))
(define-fun t179 () Float64 (fp.mul RNE t178 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t180 () Bool (fp.leq x1 x5))
(define-fun t181 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x2))
(define-fun t182 () Bool (and t51 t181))
(define-fun t183 () Bool (fp.leq t179 x2))
(define-fun t184 () Bool (fp.leq t179 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t185 () Bool (and t15 t33))
(define-fun t186 () Bool (and t180 t185))
(define-fun t187 () Bool (and t182 t186))
(define-fun t188 () Bool (and t183 t187))
(define-fun t189 () Bool (and t184 t188))
(define-fun t190 () Bool (and (not t6) t189))
(define-fun t192 () Bool (and (not t161) (not t190)))
(define-fun t194 () Bool (fp.lt x2 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t195 () Bool (fp.leq x1 x3))
(define-fun t196 () Float64 (fp.sub RNE x3 x1))
(define-fun t197 () Float64 (fp.mul RNE t196 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t198 () Bool (fp.leq t197 x2))
(define-fun t199 () Bool (fp.leq t197 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t200 () Bool (and t33 t53))
(define-fun t201 () Bool (and t195 t200))
(define-fun t202 () Bool (and t182 t201))
(define-fun t203 () Bool (and t198 t202))
(define-fun t204 () Bool (and t199 t203))
(define-fun t206 () Bool (fp.leq x1 x4))
(define-fun t207 () Float64 (fp.sub RNE x4 x1))
(define-fun t208 () Float64 (fp.mul RNE t207 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t209 () Bool (fp.leq t208 x2))
(define-fun t210 () Bool (fp.leq t208 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t211 () Bool (and t21 t33))
(define-fun t212 () Bool (and t206 t211))
(define-fun t213 () Bool (and t182 t212))
(define-fun t214 () Bool (and t209 t213))
(define-fun t215 () Bool (and t210 t214))
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert (not t45))(assert t33)(assert t34)(assert (not t136))(assert t20)(assert t31)(assert t32)(assert t37)(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert (not t45))(assert t33)(assert t34)(assert t136)(assert t20)(assert t31)(assert t32)(assert t36)(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t45)(assert t15)(assert t17)(assert (not t19))(assert t20)(assert t21)(assert t22)(assert t70)(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t45)(assert t15)(assert t17)(assert t19)(assert t20)(assert t21)(assert t22)(assert t26)(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert (not t10))(assert t53)(assert t54)(assert (not t82))(assert t20)(assert t51)(assert t52)(assert t57)(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert (not t10))(assert t53)(assert t54)(assert t82)(assert t20)(assert t51)(assert t52)(assert t56)(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t10)(assert t15)(assert t17)(assert (not t19))(assert t20)(assert t21)(assert t22)(assert t70)(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t10)(assert t15)(assert t17)(assert t19)(assert t20)(assert t21)(assert t22)(assert t26)(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert t21)(assert t89)(assert t91)(assert (not t96))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert t21)(assert t89)(assert t90)(assert (not t96))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert (not t104))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert (not t104))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert (not t104))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert (not t104))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert (not t105))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert (not t105))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert (not t136))(assert t21)(assert t31)(assert t89)(assert t91)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert (not t136))(assert t21)(assert t31)(assert t89)(assert t91)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert (not t136))(assert t21)(assert t31)(assert t89)(assert t91)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert (not t136))(assert t21)(assert t31)(assert t89)(assert t91)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert (not t136))(assert t21)(assert t31)(assert t89)(assert t91)(assert (not t15))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert (not t136))(assert t21)(assert t31)(assert t89)(assert t91)(assert t15)(assert (not t115))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert (not t136))(assert t21)(assert t31)(assert t89)(assert t91)(assert t15)(assert t115)(assert (not t117))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert (not t136))(assert t21)(assert t31)(assert t89)(assert t91)(assert t15)(assert t115)(assert t117)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert (not t136))(assert t21)(assert t31)(assert t89)(assert t91)(assert (not t45))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert (not t136))(assert t21)(assert t31)(assert t89)(assert t91)(assert t45)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert t136)(assert t21)(assert t31)(assert t89)(assert t90)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert t136)(assert t21)(assert t31)(assert t89)(assert t90)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert t136)(assert t21)(assert t31)(assert t89)(assert t90)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert t136)(assert t21)(assert t31)(assert t89)(assert t90)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert t136)(assert t21)(assert t31)(assert t89)(assert t90)(assert (not t15))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert t136)(assert t21)(assert t31)(assert t89)(assert t90)(assert t15)(assert (not t115))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert t136)(assert t21)(assert t31)(assert t89)(assert t90)(assert t15)(assert t115)(assert (not t116))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert t136)(assert t21)(assert t31)(assert t89)(assert t90)(assert t15)(assert t115)(assert t116)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert t136)(assert t21)(assert t31)(assert t89)(assert t90)(assert (not t45))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert t136)(assert t21)(assert t31)(assert t89)(assert t90)(assert t45)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert (not t10))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert t10)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert (not t15))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert t15)(assert (not t109))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert t15)(assert t109)(assert (not t125))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert t15)(assert t109)(assert t125)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert (not t10))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert t10)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert (not t15))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert t15)(assert (not t109))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert t15)(assert t109)(assert (not t112))(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert t15)(assert t109)(assert t112)(assert (not (not t107)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert (not t136))(assert t21)(assert t31)(assert t89)(assert t91)(assert t15)(assert t115)(assert t117)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t33)(assert t34)(assert t136)(assert t21)(assert t31)(assert t89)(assert t90)(assert t15)(assert t115)(assert t116)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert (not t82))(assert t21)(assert t51)(assert t83)(assert t99)(assert t15)(assert t109)(assert t125)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t53)(assert t54)(assert t82)(assert t21)(assert t51)(assert t83)(assert t86)(assert t15)(assert t109)(assert t112)(assert (not (not t133)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert (not t15))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert t15)(assert (not t115))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert t15)(assert t115)(assert (not t117))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert t15)(assert t115)(assert t117)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert (not t45))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert t45)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert (not t10))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t10)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert (not t21))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert (not t148))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert (not t15))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert (not t150))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert (not t155))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert t149)(assert (not t15))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert (not t150))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert (not t153))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t53))(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t53))(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert (not t165))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert (not t165))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert (not t165))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert (not t165))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert (not t165))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert (not t165))(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert (not t165))(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert (not t169))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert (not t169))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert (not t169))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert (not t169))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert (not t169))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert (not t169))(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert (not t169))(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t21))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert t21)(assert (not t89))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert t21)(assert t89)(assert (not t91))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert t21)(assert t89)(assert t91)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert (not t15))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert t15)(assert (not t115))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert t15)(assert t115)(assert (not t116))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert t15)(assert t115)(assert t116)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert (not t45))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert t45)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert (not t10))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t10)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert (not t21))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert (not t148))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert (not t15))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert (not t150))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert (not t155))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert t149)(assert (not t15))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert (not t150))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert (not t153))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t53))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t53))(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t53))(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert (not t165))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert (not t165))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert (not t165))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert (not t165))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert (not t165))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert (not t165))(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert (not t165))(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert (not t168))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert (not t168))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert (not t168))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert (not t168))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert (not t168))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert (not t168))(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert (not t168))(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t6))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert t6)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t21))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert t21)(assert (not t89))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert t21)(assert t89)(assert (not t90))(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert t21)(assert t89)(assert t90)(assert (not t146))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t33))(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t33))(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert (not t34))(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert (not t34))(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert (not t51))(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert (not t51))(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert (not t31))(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert (not t31))(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert (not t137))(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert (not t137))(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert (not t141))(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert (not t141))(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert (not t51))(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert (not t51))(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert (not t31))(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert (not t31))(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert (not t137))(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert (not t137))(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert (not t140))(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert (not t140))(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not t161))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert (not t6))(assert t15)(assert t115)(assert t117)(assert (not (not t163)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not (not t163)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not (not t163)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert (not t6))(assert t15)(assert t115)(assert t116)(assert (not (not t163)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not (not t163)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not (not t163)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t6))(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert t6)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert (not t21))(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert t21)(assert (not t89))(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert t21)(assert t89)(assert (not t91))(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert (not t136))(assert t51)(assert t31)(assert t137)(assert t141)(assert t53)(assert t165)(assert t169)(assert t21)(assert t89)(assert t91)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t6))(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert t6)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert (not t21))(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert t21)(assert (not t89))(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert t21)(assert t89)(assert (not t90))(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t33)(assert t34)(assert t136)(assert t51)(assert t31)(assert t137)(assert t140)(assert t53)(assert t165)(assert t168)(assert t21)(assert t89)(assert t90)(assert (not t174))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t51)(assert t181)(assert (not t194))(assert t15)(assert t33)(assert t180)(assert t184)(assert (not (not t192)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert (not t6))(assert t51)(assert t181)(assert t194)(assert t15)(assert t33)(assert t180)(assert t183)(assert (not (not t192)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t21)(assert t148)(assert (not t149))(assert t15)(assert t53)(assert t150)(assert t155)(assert (not (not t192)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t6)(assert t21)(assert t148)(assert t149)(assert t15)(assert t53)(assert t150)(assert t153)(assert (not (not t192)))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert (not t6))(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert t6)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert (not t21))(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert t21)(assert (not t206))(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert t21)(assert t206)(assert (not t210))(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert t21)(assert t206)(assert t210)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert (not t6))(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert t6)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert (not t21))(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert t21)(assert (not t206))(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert t21)(assert t206)(assert (not t209))(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert t21)(assert t206)(assert t209)(assert (not t204))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert (not t194))(assert t53)(assert t33)(assert t195)(assert t199)(assert t21)(assert t206)(assert t210)(assert (not t215))
(check-sat)
(pop 1)
(push 1) ; moves only by an advancing command that is alive
(assert t51)(assert t181)(assert t194)(assert t53)(assert t33)(assert t195)(assert t198)(assert t21)(assert t206)(assert t209)(assert (not t215))
(check-sat)
(pop 1)
