; clamp/tick: limit_tick(channels, limit) is ok ⇔ ¬faulty ∧ fin(channels) ∧ (enabled ⇒ velocity is named, 3 wide, in m/s); and then ∀ c in m/s: ‖c‖ ≤ max
; Each answer has to be unsat, 191 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const x2 Float64)
(declare-const x3 Float64)
(define-fun t5 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t6 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t7 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t9 () Bool (and t6 t7))
(define-fun t10 () Bool (and t5 t9))
(declare-const x4 Float64)
(define-fun t14 () Bool (not (or (fp.isNaN x4) (fp.isInfinite x4))))
(define-fun t15 () Bool (and t10 t14))
(declare-const x5 Float64)
(define-fun t18 () Bool (not (or (fp.isNaN x5) (fp.isInfinite x5))))
(define-fun t19 () Bool (and t15 t18))
(define-fun t21 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t22 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t23 () Float64 (fp.mul RNE x3 x3))
(define-fun t40 () Bool (and t21 t22))
(define-fun t42 () Bool (and (not t10) t40))
(define-fun t44 () Bool (and t10 t40))
(define-fun t47 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110111)))
(define-fun t78 () Float64 (fp.mul RNE x1 x1))
(define-fun t79 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t78))
(define-fun t80 () Float64 (fp.mul RNE x2 x2))
(define-fun t81 () Float64 (fp.add RNE t79 t80))
(define-fun t140 () Float64 (fp.mul RNE x4 x4))
(define-fun t141 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t140))
(define-fun t142 () Bool (fp.lt t141 (fp #b0 #b11111100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t143 () Float64 (ite t142 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000) (fp #b0 #b00110100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t144 () Bool (fp.lt t141 (fp #b0 #b00001111011 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t145 () Float64 (ite t144 (fp #b0 #b11001010111 #b0000000000000000000000000000000000000000000000000000) t143))
(define-fun t146 () Float64 (fp.mul RNE x4 t145))
(define-fun t147 () Float64 (fp.mul RNE t146 t146))
(define-fun t148 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t147))
(define-fun t149 () Float64 (fp.sqrt RNE t148))
(define-fun t150 () Float64 (fp.mul RNE x0 t145))
(define-fun t151 () Bool (fp.leq t149 t150))
(define-fun t152 () Bool (and (not t15) t40))
(define-fun t154 () Bool (and t15 t40))
(define-fun t156 () Float64 (fp.mul RNE t47 t145))
(define-fun t157 () Float64 (fp.div RNE t156 t149))
(define-fun t158 () Bool (fp.leq (fp #b0 #b00001111011 #b0000000000000000000000000000000000000000000000000000) t157))
(define-fun t159 () Float64 (fp.mul RNE x4 t157))
(define-fun t160 () Float64 (fp.mul RNE t159 t159))
(define-fun t161 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t160))
(define-fun t162 () Bool (fp.lt t161 (fp #b0 #b11111100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t163 () Float64 (ite t162 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000) (fp #b0 #b00110100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t164 () Bool (fp.lt t161 (fp #b0 #b00001111011 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t165 () Float64 (ite t164 (fp #b0 #b11001010111 #b0000000000000000000000000000000000000000000000000000) t163))
(define-fun t166 () Float64 (fp.mul RNE t159 t165))
(define-fun t167 () Float64 (fp.mul RNE t166 t166))
(define-fun t168 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t167))
(define-fun t169 () Float64 (fp.sqrt RNE t168))
(define-fun t170 () Float64 (fp.mul RNE x0 t165))
(define-fun t171 () Bool (fp.leq t169 t170))
(define-fun t172 () Float64 (fp.div RNE t146 t149))
(define-fun t173 () Float64 (fp.mul RNE t172 t47))
(define-fun t174 () Float64 (fp.mul RNE t173 t173))
(define-fun t175 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t174))
(define-fun t176 () Bool (fp.lt t175 (fp #b0 #b11111100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t177 () Float64 (ite t176 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000) (fp #b0 #b00110100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t178 () Bool (fp.lt t175 (fp #b0 #b00001111011 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t179 () Float64 (ite t178 (fp #b0 #b11001010111 #b0000000000000000000000000000000000000000000000000000) t177))
(define-fun t180 () Float64 (fp.mul RNE t173 t179))
(define-fun t181 () Float64 (fp.mul RNE t180 t180))
(define-fun t182 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t181))
(define-fun t183 () Float64 (fp.sqrt RNE t182))
(define-fun t184 () Float64 (fp.mul RNE x0 t179))
(define-fun t185 () Bool (fp.leq t183 t184))
(define-fun t186 () Float64 (fp.add RNE t81 t23))
(define-fun t187 () Bool (fp.lt t186 (fp #b0 #b11111100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t188 () Float64 (ite t187 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000) (fp #b0 #b00110100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t189 () Bool (fp.lt t186 (fp #b0 #b00001111011 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t190 () Float64 (ite t189 (fp #b0 #b11001010111 #b0000000000000000000000000000000000000000000000000000) t188))
(define-fun t191 () Float64 (fp.mul RNE x1 t190))
(define-fun t192 () Float64 (fp.mul RNE t191 t191))
(define-fun t193 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t192))
(define-fun t194 () Float64 (fp.mul RNE x2 t190))
(define-fun t195 () Float64 (fp.mul RNE t194 t194))
(define-fun t196 () Float64 (fp.add RNE t193 t195))
(define-fun t197 () Float64 (fp.mul RNE x3 t190))
(define-fun t198 () Float64 (fp.mul RNE t197 t197))
(define-fun t199 () Float64 (fp.add RNE t196 t198))
(define-fun t200 () Float64 (fp.sqrt RNE t199))
(define-fun t201 () Float64 (fp.mul RNE x0 t190))
(define-fun t202 () Bool (fp.leq t200 t201))
(define-fun t204 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110101)))
(define-fun t205 () Float64 (fp.mul RNE t204 t190))
(define-fun t206 () Float64 (fp.div RNE t205 t200))
(define-fun t207 () Bool (fp.leq (fp #b0 #b00001111011 #b0000000000000000000000000000000000000000000000000000) t206))
(define-fun t208 () Float64 (fp.mul RNE x1 t206))
(define-fun t209 () Float64 (fp.mul RNE x2 t206))
(define-fun t210 () Float64 (fp.mul RNE x3 t206))
(define-fun t211 () Float64 (fp.mul RNE t208 t208))
(define-fun t212 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t211))
(define-fun t213 () Float64 (fp.mul RNE t209 t209))
(define-fun t214 () Float64 (fp.add RNE t212 t213))
(define-fun t215 () Float64 (fp.mul RNE t210 t210))
(define-fun t216 () Float64 (fp.add RNE t214 t215))
(define-fun t217 () Bool (fp.lt t216 (fp #b0 #b11111100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t218 () Float64 (ite t217 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000) (fp #b0 #b00110100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t219 () Bool (fp.lt t216 (fp #b0 #b00001111011 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t220 () Float64 (ite t219 (fp #b0 #b11001010111 #b0000000000000000000000000000000000000000000000000000) t218))
(define-fun t221 () Float64 (fp.mul RNE t208 t220))
(define-fun t222 () Float64 (fp.mul RNE t221 t221))
(define-fun t223 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t222))
(define-fun t224 () Float64 (fp.mul RNE t209 t220))
(define-fun t225 () Float64 (fp.mul RNE t224 t224))
(define-fun t226 () Float64 (fp.add RNE t223 t225))
(define-fun t227 () Float64 (fp.mul RNE t210 t220))
(define-fun t228 () Float64 (fp.mul RNE t227 t227))
(define-fun t229 () Float64 (fp.add RNE t226 t228))
(define-fun t230 () Float64 (fp.sqrt RNE t229))
(define-fun t231 () Float64 (fp.mul RNE x0 t220))
(define-fun t232 () Bool (fp.leq t230 t231))
(define-fun t233 () Float64 (fp.div RNE t191 t200))
(define-fun t234 () Float64 (fp.mul RNE t233 t204))
(define-fun t235 () Float64 (fp.div RNE t194 t200))
(define-fun t236 () Float64 (fp.mul RNE t235 t204))
(define-fun t237 () Float64 (fp.div RNE t197 t200))
(define-fun t238 () Float64 (fp.mul RNE t237 t204))
(define-fun t239 () Float64 (fp.mul RNE t234 t234))
(define-fun t240 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t239))
(define-fun t241 () Float64 (fp.mul RNE t236 t236))
(define-fun t242 () Float64 (fp.add RNE t240 t241))
(define-fun t243 () Float64 (fp.mul RNE t238 t238))
(define-fun t244 () Float64 (fp.add RNE t242 t243))
(define-fun t245 () Bool (fp.lt t244 (fp #b0 #b11111100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t246 () Float64 (ite t245 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000) (fp #b0 #b00110100111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t247 () Bool (fp.lt t244 (fp #b0 #b00001111011 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t248 () Float64 (ite t247 (fp #b0 #b11001010111 #b0000000000000000000000000000000000000000000000000000) t246))
(define-fun t249 () Float64 (fp.mul RNE t234 t248))
(define-fun t250 () Float64 (fp.mul RNE t249 t249))
(define-fun t251 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t250))
(define-fun t252 () Float64 (fp.mul RNE t236 t248))
(define-fun t253 () Float64 (fp.mul RNE t252 t252))
(define-fun t254 () Float64 (fp.add RNE t251 t253))
(define-fun t255 () Float64 (fp.mul RNE t238 t248))
(define-fun t256 () Float64 (fp.mul RNE t255 t255))
(define-fun t257 () Float64 (fp.add RNE t254 t256))
(define-fun t258 () Float64 (fp.sqrt RNE t257))
(define-fun t259 () Float64 (fp.mul RNE x0 t248))
(define-fun t260 () Bool (fp.leq t258 t259))
(define-fun t262 () Bool (= x1 t208))
(define-fun t263 () Bool (= x2 t209))
(define-fun t264 () Bool (= x3 t210))
(define-fun t265 () Bool (and t262 t263))
(define-fun t266 () Bool (and t264 t265))
(define-fun t268 () Bool (and t202 (not t266)))
(define-fun t270 () Float64 (fp.mul RNE x0 (fp #b0 #b11001010111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t271 () Bool (fp.leq (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t270))
(define-fun t272 () Bool (= x1 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t273 () Bool (= x2 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t274 () Bool (= x3 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t275 () Bool (and t272 t273))
(define-fun t276 () Bool (and t274 t275))
(define-fun t278 () Bool (and t202 (not t276)))
(define-fun t280 () Bool (= x1 t234))
(define-fun t281 () Bool (= x2 t236))
(define-fun t282 () Bool (= x3 t238))
(define-fun t283 () Bool (and t280 t281))
(define-fun t284 () Bool (and t282 t283))
(define-fun t286 () Bool (and t202 (not t284)))
(define-fun t289 () Bool (and t151 t202))
(define-fun t291 () Bool (= x4 t159))
(define-fun t293 () Bool (and t151 (not t291)))
(define-fun t295 () Bool (= x4 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t297 () Bool (and t151 (not t295)))
(define-fun t299 () Bool (= x4 t173))
(define-fun t301 () Bool (and t151 (not t299)))
(define-fun t315 () Bool (and (not t19) t40))
(define-fun t317 () Bool (and t19 t40))
(push 1) ; a channel that is not above it is as it was
(assert (not t202))(assert (not (not t268)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t202))(assert (not (not t278)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t202))(assert (not (not t286)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t151))(assert (not (not t293)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t151))(assert (not (not t297)))
(check-sat)
(pop 1)
(push 1) ; a channel that is not above it is as it was
(assert (not t151))(assert (not (not t301)))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t151)(assert (not t151))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t171)(assert (not t171))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t185)(assert (not t185))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t202)(assert (not t202))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t232)(assert (not t232))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t260)(assert (not t260))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert (not t207))(assert (not t260))(assert t14)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert (not t207))(assert (not t260))(assert t14)(assert (not t151))(assert (not t158))(assert (not t185))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert (not t207))(assert (not t260))(assert t14)(assert (not t151))(assert (not t158))(assert (not t185))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert (not t207))(assert (not t260))(assert t14)(assert (not t151))(assert (not t158))(assert t185)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert (not t207))(assert (not t260))(assert t14)(assert (not t151))(assert t158)(assert (not t171))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert (not t207))(assert (not t260))(assert t14)(assert (not t151))(assert t158)(assert (not t171))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert (not t207))(assert (not t260))(assert t14)(assert (not t151))(assert t158)(assert t171)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert (not t207))(assert (not t260))(assert t14)(assert t151)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert (not t207))(assert t260)(assert t14)(assert (not t151))(assert (not t158))(assert (not t185))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert (not t207))(assert t260)(assert t14)(assert (not t151))(assert t158)(assert (not t171))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert t207)(assert (not t232))(assert t14)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert t207)(assert (not t232))(assert t14)(assert (not t151))(assert (not t158))(assert (not t185))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert t207)(assert (not t232))(assert t14)(assert (not t151))(assert (not t158))(assert (not t185))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert t207)(assert (not t232))(assert t14)(assert (not t151))(assert (not t158))(assert t185)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert t207)(assert (not t232))(assert t14)(assert (not t151))(assert t158)(assert (not t171))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert t207)(assert (not t232))(assert t14)(assert (not t151))(assert t158)(assert (not t171))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert t207)(assert (not t232))(assert t14)(assert (not t151))(assert t158)(assert t171)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert t207)(assert (not t232))(assert t14)(assert t151)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert t207)(assert t232)(assert t14)(assert (not t151))(assert (not t158))(assert (not t185))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert t207)(assert t232)(assert t14)(assert (not t151))(assert t158)(assert (not t171))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert t202)(assert t14)(assert (not t151))(assert (not t158))(assert (not t185))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert t202)(assert t14)(assert (not t151))(assert t158)(assert (not t171))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert (not t207))(assert (not t260))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t6)(assert t7)(assert t5)(assert t21)(assert t22)(assert (not t202))(assert t207)(assert (not t232))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert (not t158))(assert (not t185))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert (not t207))(assert (not t260))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert (not t158))(assert (not t185))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert (not t207))(assert (not t260))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert (not t158))(assert (not t185))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert (not t207))(assert t260)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert (not t158))(assert (not t185))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert t207)(assert (not t232))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert (not t158))(assert (not t185))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert t207)(assert (not t232))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert (not t158))(assert (not t185))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert t207)(assert t232)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert (not t158))(assert (not t185))(assert t6)(assert t7)(assert t5)(assert t202)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert (not t158))(assert t185)(assert t6)(assert t7)(assert t5)(assert (not t202))(assert (not t207))(assert (not t260))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert (not t158))(assert t185)(assert t6)(assert t7)(assert t5)(assert (not t202))(assert t207)(assert (not t232))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert t158)(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert (not t207))(assert (not t260))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert t158)(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert (not t207))(assert (not t260))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert t158)(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert (not t207))(assert t260)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert t158)(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert t207)(assert (not t232))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert t158)(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert t207)(assert (not t232))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert t158)(assert (not t171))(assert t6)(assert t7)(assert t5)(assert (not t202))(assert t207)(assert t232)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert t158)(assert (not t171))(assert t6)(assert t7)(assert t5)(assert t202)(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert t158)(assert t171)(assert t6)(assert t7)(assert t5)(assert (not t202))(assert (not t207))(assert (not t260))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert (not t151))(assert t158)(assert t171)(assert t6)(assert t7)(assert t5)(assert (not t202))(assert t207)(assert (not t232))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert t151)(assert t6)(assert t7)(assert t5)(assert (not t202))(assert (not t207))(assert (not t260))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t14)(assert t21)(assert t22)(assert t151)(assert t6)(assert t7)(assert t5)(assert (not t202))(assert t207)(assert (not t232))(assert (not t271))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t10))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t15))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t14))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t18))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t18))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t21))(assert (not (not t42)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t21)(assert (not t22))(assert (not (not t42)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t21)(assert t22)(assert (not (not t42)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t21))(assert (not (not t42)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t21)(assert (not t22))(assert (not (not t42)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert t7)(assert (not t21))(assert (not (not t42)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert t7)(assert t21)(assert (not t22))(assert (not (not t42)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert (not (not t44)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t44)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t21)(assert t22)(assert (not (not t44)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t6))(assert (not (not t44)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t6))(assert t21)(assert t22)(assert (not (not t44)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert (not (not t44)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert t21)(assert t22)(assert (not (not t44)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t44)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t44)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t21))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t21)(assert (not t22))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t21)(assert t22)(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t21))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t21)(assert (not t22))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t14)(assert (not t21))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t14)(assert t21)(assert (not t22))(assert (not (not t152)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert t21)(assert t22)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t21)(assert t22)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t14)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t14)(assert t21)(assert t22)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t14)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t14)(assert t21)(assert t22)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t14))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t18)(assert (not t21))(assert (not (not t315)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t18)(assert t21)(assert (not t22))(assert (not (not t315)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t18)(assert t21)(assert t22)(assert (not (not t315)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t21))(assert (not (not t315)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert t21)(assert (not t22))(assert (not (not t315)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t18)(assert (not t21))(assert (not (not t315)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t18)(assert t21)(assert (not t22))(assert (not (not t315)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t18)(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert t6)(assert t7)(assert t18)(assert t21)(assert t22)(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t18)(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t18)(assert t21)(assert t22)(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t18))(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t18))(assert t21)(assert t22)(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t18)(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t6))(assert t18)(assert t21)(assert t22)(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t18)(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t6)(assert (not t7))(assert t18)(assert t21)(assert t22)(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t18))(assert (not (not t317)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t202)(assert (not t202))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t202))(assert (not (not t202)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t151)(assert t202)(assert (not t289))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t151))(assert (not t202))(assert (not (not t289)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t151))(assert t202)(assert (not (not t289)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t151)(assert (not t202))(assert (not (not t289)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t10))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t15))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert t14)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t14))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert t18)(assert (not t19))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t18))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert t18)(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t18))(assert (not (not t19)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert t21)(assert t22)(assert (not t154))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert t6)(assert t7)(assert t14)(assert t21)(assert t22)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t14))(assert t21)(assert t22)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert (not t21))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t14)(assert t21)(assert (not t22))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t21))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t21)(assert (not t22))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert t14)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t6))(assert t14)(assert t21)(assert t22)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert t14)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t6)(assert (not t7))(assert t14)(assert t21)(assert t22)(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t14))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t14)(assert (not t21))(assert (not (not t154)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t14)(assert t21)(assert (not t22))(assert (not (not t154)))
(check-sat)
(pop 1)
