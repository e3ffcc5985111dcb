/* The lane executor's job, written by hand in C: what a compiler can be asked to reach.
 *
 * One vehicle with four arms in the body plane, ring contact points, one plane with the Hunt-Crossley
 * law of exponent 3/2 and isotropic regularised friction, classical Runge-Kutta, the energy ledger,
 * every streaming measure, the choice of steps that land on crossings, the phases and the locking of
 * settled arms.  The equations are those of springback.dynamics.motion, in body axes.
 *
 * LANES flights share one vector of the compiler's vector extension; with LANES = 1 the same
 * source is the scalar variant.  Nothing branches inside a stage: selections go through masks.
 *
 *     gcc -O3 -march=native -fno-math-errno -shared -fPIC -DLANES=4 reference.c -lm
 */
#include <math.h>
#include <string.h>

#ifndef LANES
#define LANES 4
#endif
#define ARMS 4
#define INLINE static inline __attribute__((always_inline))

#if LANES == 1
typedef double V;
typedef long M;
#define LANE(v, i) (*(&(v) + (i)))
INLINE V all(double x) { return x; }
INLINE V sel(M m, V a, V b) { return m ? a : b; }
INLINE V root(V x) { return sqrt(x); }
#else
typedef double V __attribute__((vector_size(8 * LANES)));
typedef long M __attribute__((vector_size(8 * LANES)));
#define LANE(v, i) ((v)[i])
INLINE V all(double x) { return x - (V){0}; }
INLINE V sel(M m, V a, V b) { return (V)((m & (M)a) | (~m & (M)b)); }
INLINE V root(V x)
{
    V r;
    for (int i = 0; i < LANES; i++)
        r[i] = sqrt(x[i]);
    return r;
}
#endif

INLINE V larger(V a, V b) { return sel(a > b, a, b); }
INLINE V smaller(V a, V b) { return sel(a < b, a, b); }
INLINE V positive(V x) { return larger(x, all(0)); }
INLINE V one_if(M m) { return sel(m, all(1), all(0)); }

typedef struct { V x, y, z; } Vec;

INLINE Vec vec(V x, V y, V z) { return (Vec){x, y, z}; }
INLINE Vec plus(Vec a, Vec b) { return vec(a.x + b.x, a.y + b.y, a.z + b.z); }
INLINE Vec minus(Vec a, Vec b) { return vec(a.x - b.x, a.y - b.y, a.z - b.z); }
INLINE Vec times(Vec a, V s) { return vec(a.x * s, a.y * s, a.z * s); }
INLINE V dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
INLINE V norm(Vec a) { return root(dot(a, a)); }
INLINE Vec either(M m, Vec a, Vec b)
{
    return vec(sel(m, a.x, b.x), sel(m, a.y, b.y), sel(m, a.z, b.z));
}
INLINE Vec cross(Vec a, Vec b)
{
    return vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/* All structures are plain rows of V, so that they can be filled and summed row by row. */
typedef struct {
    V cosine, sine, mass, inverse_mass, stiffness, damping, length, shortest;
    V stop_stiffness, stop_dissipation, compliance, cage_radius, torque_ratio;
} Arm;

typedef struct {
    V mass, inverse_mass;
    V inertia[9];
    Arm arm[ARMS];
    V released[3], locked[3]; /* inverse of the mass of translation: xx, yy, xy */
    Vec normal;
    V offset, stiffness, dissipation, viscosity, friction, slip_speed, is_ground;
    V gravity, rounding;
    V thrust[ARMS];
    V until, free_step, impact_step, settle_step, arm_tolerance, rate_tolerance, dwell, hybrid;
} Model;

typedef struct {
    Vec position;
    V qw, qx, qy, qz;
    Vec velocity, omega;
    V length[ARMS], rate[ARMS];
} State;

typedef struct {
    V thrust, arm, stop, contact, friction, settling, air;
    Vec impulse;
} Work;

typedef struct { State state; Work work; } Motion;

typedef struct {
    V time, step, status, phase, lock;
    V steps, touching, contacts, arm_touching[ARMS], arm_contacts[ARMS];
    V impacts, impact_open, last_touch_time, contact_duration;
    Vec inward;
    V touch_time, touch_depth, touch_speed, touch_mass_centre_speed;
    V separation_time, separation_speed, separation_mass_centre_speed, return_time, return_speed;
    V peak_acceleration, peak_acceleration_time, peak_specific_force, peak_angular_rate;
    V peak_normal_force, peak_penetration, peak_compression, peak_extension;
    V impact_peak_acceleration, impact_peak_acceleration_time, impact_peak_specific_force;
    V impact_peak_angular_rate, impact_peak_normal_force, impact_penetration, impact_arm_stroke;
    V impact_arm_extension, travel;
    V bottomed_time, ground_time;
    V recent_step, earlier[3], latest[3];
} Record;

/* A value on its way to zero, there after distance / speed. */
typedef struct { V distance, speed; } Crossing;

/* What the measures need of one instant. */
typedef struct {
    Vec acceleration, specific_force, mass_centre_velocity;
    V touching[ARMS];
    Vec touched_normal;
    Crossing crossing;
    V largest_normal, deepest, most_compressed, least_compressed;
    V bottomed, on_ground, nearest;
    V friction_rate; /* at most how fast friction brings a sliding cage to rest */
    V contact_rate;  /* how fast contacts and end stops act */
    V slip_rate;     /* how fast a slip changes */
    V stopped;       /* 1 while an end stop is pressed */
    V unbalance[ARMS];
} View;

#define ROWS(T) ((int)(sizeof(T) / sizeof(V)))
enum { FLYING = 0, FINISHED = 1, NOT_FINITE = 2 };
static const double LANDED = 1e-9, NEVER = 1e9, SHORTEST = 1e-3, DIVERGED = 1e12;
static const double FRICTION_SHARE = 2, TINY = 1e-9, AT_TOUCH = 1e-30;
static const double CONTACT_SHARE = 0.35, SLIP_SHARE = 0.25, AHEAD = 1e-4, GRAZED = 1e-7;
static const double APPROACH = 0.98, SUDDEN = 2;

INLINE Crossing crossing(V value, V rate)
{
    const M ahead = (value * rate < all(0)) & (value * value > all(LANDED * LANDED));
    const V distance = sel(value > all(0), value, -value), speed = sel(rate > all(0), rate, -rate);
    return (Crossing){sel(ahead, distance, all(NEVER)), sel(ahead, speed, all(1))};
}

/* Compared as fractions, so that only the soonest is divided out. */
INLINE Crossing sooner(Crossing a, Crossing b)
{
    const M first = a.distance * b.speed < b.distance * a.speed;
    return (Crossing){sel(first, a.distance, b.distance), sel(first, a.speed, b.speed)};
}

typedef struct { Vec x, y, z; } Mat; /* rows */

INLINE Vec to_world(const Mat *r, Vec a) { return vec(dot(r->x, a), dot(r->y, a), dot(r->z, a)); }
INLINE Vec to_body(const Mat *r, Vec a)
{
    return plus(plus(times(r->x, a.x), times(r->y, a.y)), times(r->z, a.z));
}

INLINE Mat rotation(V w, V x, V y, V z)
{
    V one = all(1), x2 = x + x, y2 = y + y, z2 = z + z;
    V xx = x * x2, yy = y * y2, zz = z * z2, xy = x * y2, xz = x * z2, yz = y * z2;
    V wx = w * x2, wy = w * y2, wz = w * z2;
    return (Mat){
        vec(one - (yy + zz), xy - wz, xz + wy),
        vec(xy + wz, one - (xx + zz), yz - wx),
        vec(xz - wy, yz + wx, one - (xx + yy)),
    };
}

/* Rates of everything that is integrated; the view too, where one is asked for.  Without a view, cages
 * that were apart at the beginning of the step feel nothing. */
INLINE void rates(const Model *m, const State *s, V released, const V *engaged, Motion *rate, View *view)
{
    const Mat r = rotation(s->qw, s->qx, s->qy, s->qz);
    const Vec w = s->omega, v = to_body(&r, s->velocity);

    /* The plane as the body sees it: inward normal and distance; one support point direction. */
    const Vec n = times(to_body(&r, m->normal), all(-1));
    const V distance = dot(m->normal, s->position) - m->offset;
    const V eps = m->rounding;
    const V inverse = all(1) / root(n.x * n.x + n.y * n.y + eps * eps);
    const V ring_x = n.x * inverse, ring_y = n.y * inverse, inset = eps * eps * inverse;
    const V squared_slip_speed = m->slip_speed * m->slip_speed, wzz = w.z * w.z;

    Vec force = vec(all(0), all(0), all(0)), moment = force;
    V thrust = all(0), rotor_x = thrust, rotor_y = thrust, rotor_z = thrust;
    V taken_x = thrust, taken_y = thrust, carried_x = thrust, carried_y = thrust;
    V drift_x = thrust, drift_y = thrust;
    V j_xx = thrust, j_yy = thrust, j_xy = thrust, dj_xx = thrust, dj_yy = thrust, dj_xy = thrust;
    V arm_loss = thrust, stop_loss = thrust, contact_loss = thrust, friction_loss = thrust;
    V drive[ARMS], hold[ARMS];
    /* Friction as a damper: of the vehicle in the plane of the arms and of its turns, of the worst arm;
     * `lean` is what normals that lean out of that plane add. */
    V grip_all = thrust, grip_z = thrust, grip_xx = thrust, grip_yy = thrust, grip_xy = thrust;
    V lean_all = thrust, lean_z = thrust, grip_arm = thrust, lean_arm = thrust;
    /* Contacts and stops as springs and dampers: of the vehicle, of its turns, of the worst arm. */
    V press_k = thrust, press_c = thrust, arm_k = thrust, arm_c = thrust;
    V rub_x[ARMS], rub_y[ARMS], per_speed[ARMS];

    V quickest = all(0), farthest = all(0);
#pragma GCC unroll 4
    for (int j = 0; j < ARMS; j++) {
        quickest = larger(quickest, larger(s->rate[j], -s->rate[j]));
        farthest = larger(farthest, m->arm[j].length + m->arm[j].cage_radius);
    }
    /* A step looks so much deeper into a contact. */
    const V farther = all(AHEAD) * (norm(s->velocity) + farthest * norm(w) + quickest);

    if (view) {
        memset(view, 0, sizeof *view);
        view->crossing = (Crossing){all(NEVER), all(1)};
        view->largest_normal = view->deepest = view->most_compressed = all(-NEVER);
        view->least_compressed = view->nearest = all(NEVER);
    }
#pragma GCC unroll 4
    for (int j = 0; j < ARMS; j++) {
        const Arm *a = &m->arm[j];
        const V c = a->cosine, q = a->sine, l = s->length[j], dl = s->rate[j];
        const V u = a->compliance * released;
        const V x = l * c, y = l * q;

        /* Contact: gap, rate of approach, normal force, friction. */
        const V px = x + ring_x * a->cage_radius, py = y + ring_y * a->cage_radius;
        const V gap = distance - (n.x * px + n.y * py) - inset * a->cage_radius;
        const Vec at = vec(v.x + dl * c - w.z * py, v.y + dl * q + w.z * px, v.z + w.x * py - w.y * px);
        const V approach = dot(at, n);
        M touches = (gap < all(-AT_TOUCH)) | ((gap <= all(LANDED)) & (approach > all(0)));
        if (!view)
            touches &= engaged[j] > all(0);
        const V depth = sel(touches, larger(-gap, all(AT_TOUCH)), all(0));
        const V elastic = m->stiffness * (depth * root(depth));
        const V pressed = positive(elastic + (m->dissipation * elastic + m->viscosity) * approach);
        const V normal = sel(depth > all(0), pressed, all(0));
        const Vec slip = minus(at, times(n, approach));
        const V square = dot(slip, slip);
        const V grip = m->friction * normal / root(square + squared_slip_speed);
        const Vec f = vec(-(n.x * normal + slip.x * grip), -(n.y * normal + slip.y * grip),
                          -(n.z * normal + slip.z * grip));
        force = plus(force, f);
        moment = plus(moment, vec(py * f.z, -(px * f.z), px * f.y - py * f.x));
        contact_loss += (normal - elastic) * approach;
        friction_loss += grip * square;

        /* Spring, damper, stops, centrifugal force: the arm's own slide. */
        const V shift = larger(a->shortest, smaller(l, a->length)) - l;
        const V stored = a->stop_stiffness * shift;
        const V stop = stored * positive(all(1) + a->stop_dissipation * sel(shift > all(0), -dl, dl));
        const V damper = a->damping * dl;
        const V across = c * w.y - q * w.x, ml = a->mass * l;
        const V h = c * f.x + q * f.y + ml * (across * across + wzz)
                  + a->stiffness * (a->length - l) - damper + stop;
        const V uh = u * h, md = a->mass * dl;
        taken_x += uh * c;
        taken_y += uh * q;
        drive[j] = uh * a->inverse_mass;
        hold[j] = u;
        arm_loss += u * (damper * dl);
        stop_loss += u * ((stored - stop) * dl);

        /* Moments of mass. */
        const V mx = ml * c, my = ml * q, dx = md * c, dy = md * q;
        carried_x += mx;
        carried_y += my;
        drift_x += dx;
        drift_y += dy;
        j_xx += mx * x;
        j_yy += my * y;
        j_xy += mx * y;
        dj_xx += dx * x;
        dj_yy += dy * y;
        dj_xy += dx * y;

        const V t = m->thrust[j];
        thrust += t;
        rotor_x += t * y;
        rotor_y -= t * x;
        rotor_z += t * a->torque_ratio;

        if (view) {
            const M closing = (gap <= all(LANDED)) & (approach > all(0));
            const M touches = closing | (gap < all(-LANDED));
            const M slides = u > all(0), stopped = (a->stop_stiffness > all(0)) & slides;
            const V compression = a->length - l;
            const V low_ = l - a->shortest, high_ = -compression;
            const V next = sel(dl > all(0), sel(low_ < all(-LANDED), low_, high_), sel(high_ > all(LANDED), high_, low_));
            view->crossing = sooner(view->crossing, crossing(gap, -approach));
            Crossing at_stop = crossing(next, sel(stopped, dl, all(0)));
            const M away = (at_stop.distance > all(2 * GRAZED)) & (at_stop.distance < all(NEVER));
            at_stop.distance = sel(away, all(APPROACH) * at_stop.distance, at_stop.distance);
            view->crossing = sooner(view->crossing, at_stop);
            view->touching[j] = one_if(touches);
            view->touched_normal = plus(view->touched_normal, times(n, one_if(touches)));
            view->largest_normal = larger(view->largest_normal, normal);
            view->deepest = larger(view->deepest, positive(-gap));
            view->nearest = smaller(view->nearest, gap);
            view->most_compressed = larger(view->most_compressed, compression);
            view->least_compressed = smaller(view->least_compressed, compression);
            view->bottomed = larger(view->bottomed, one_if(stopped & (l < a->shortest + all(LANDED))));
            const V along = c * n.x + q * n.y, out = n.z * n.z, pn = px * n.x + py * n.y;
            const V upright = grip * (all(1) - out), far = px * px + py * py, give = u * a->inverse_mass;
            grip_all += grip;
            grip_z += grip * (pn * pn + out * far);
            grip_xx += upright * (py * py);
            grip_yy += upright * (px * px);
            grip_xy += upright * (px * py);
            lean_all += grip * out;
            lean_z += grip * out * far;
            grip_arm = larger(grip_arm, grip * (all(1) - along * along) * give);
            lean_arm = larger(lean_arm, grip * out * give);
            const V on = positive(approach);
            const V slope = m->stiffness * (all(1.5) * (root(depth) + root(farther)));
            const V then = elastic + slope * farther;
            const V spring = sel(depth > all(0), slope * (all(1) + m->dissipation * on), all(0));
            const V dashpot = sel(depth > all(0), m->dissipation * then + m->viscosity, all(0));
            const V out_ = all(AHEAD) * dl;
            const M soon = (-compression + out_ > all(GRAZED)) | (a->shortest - l - out_ > all(GRAZED));
            const V faster = larger(dl, -dl), inwards = positive(sel(shift > all(0), -dl, dl));
            const V rate_in = sel(shift == all(0), faster, inwards);
            const V steepest = all(SUDDEN) * a->stop_stiffness * (all(1) + a->stop_dissipation * rate_in);
            const V stopping = sel((shift != all(0)) | soon, steepest, all(0));
            const V reached = sel(stopping > all(0), larger(shift, -shift) + larger(out_, -out_), all(0));
            press_k += spring;
            press_c += dashpot;
            arm_k = larger(arm_k, (spring * (along * along) + stopping) * give);
            arm_c = larger(arm_c, (dashpot * (along * along) + a->stop_dissipation * a->stop_stiffness * reached) * give);
            view->stopped = larger(view->stopped, one_if(u * stopping > all(0)));
            rub_x[j] = px;
            rub_y[j] = py;
            per_speed[j] = sel(m->friction * normal > all(0), all(1) / root(square + squared_slip_speed), all(0));
            view->on_ground += sel(gap < all(0), m->is_ground, all(0));
        }
    }

    /* Right-hand sides. */
    const V *in = m->inertia;
    const V jxx = in[0] + j_yy, jyy = in[4] + j_xx, jzz = in[8] + (j_xx + j_yy);
    const V jxy = in[1] - j_xy, jxz = in[2], jyz = in[5];
    const Vec jw = vec(jxx * w.x + jxy * w.y + jxz * w.z, jxy * w.x + jyy * w.y + jyz * w.z,
                       jxz * w.x + jyz * w.y + jzz * w.z);
    const Vec djw = vec(dj_yy * w.x - dj_xy * w.y, dj_xx * w.y - dj_xy * w.x, (dj_xx + dj_yy) * w.z);
    const Vec rotor = vec(rotor_x, rotor_y, rotor_z);
    const Vec tau = minus(minus(plus(moment, rotor), cross(w, jw)), plus(djw, djw));
    const Vec turning = vec(-(w.z * carried_y), w.z * carried_x, w.x * carried_y - w.y * carried_x);
    const Vec swing = cross(w, vec(turning.x + drift_x + drift_x, turning.y + drift_y + drift_y, turning.z));
    const Vec b = vec(force.x - taken_x - swing.x, force.y - taken_y - swing.y,
                      force.z + thrust - swing.z);

    /* Translation first, then 3 x 3. */
    const M free = released > all(0);
    const V nxx = sel(free, m->released[0], m->locked[0]), nyy = sel(free, m->released[1], m->locked[1]);
    const V nxy = sel(free, m->released[2], m->locked[2]), nzz = m->inverse_mass;
    const Vec alone = vec(nxx * b.x + nxy * b.y, nxy * b.x + nyy * b.y, nzz * b.z);
    const V sx = carried_x, sy = carried_y, sxx = sx * sx, sxy = sx * sy, syy = sy * sy;
    const V a00 = jxx - nzz * syy, a11 = jyy - nzz * sxx, a01 = jxy + nzz * sxy;
    const V a22 = jzz - (nxx * syy - (nxy + nxy) * sxy + nyy * sxx), a02 = jxz, a12 = jyz;
    const Vec g = vec(tau.x - sy * alone.z, tau.y + sx * alone.z, tau.z - (sx * alone.y - sy * alone.x));
    const V c00 = a11 * a22 - a12 * a12, c01 = a02 * a12 - a01 * a22, c02 = a01 * a12 - a02 * a11;
    const V c11 = a00 * a22 - a02 * a02, c12 = a01 * a02 - a00 * a12, c22 = a00 * a11 - a01 * a01;
    const V one_over = all(1) / (a00 * c00 + a01 * c01 + a02 * c02);
    const Vec alpha = vec((c00 * g.x + c01 * g.y + c02 * g.z) * one_over,
                          (c01 * g.x + c11 * g.y + c12 * g.z) * one_over,
                          (c02 * g.x + c12 * g.y + c22 * g.z) * one_over);
    const Vec p = vec(-(alpha.z * sy), alpha.z * sx, alpha.x * sy - alpha.y * sx);
    const Vec felt = vec(alone.x - (nxx * p.x + nxy * p.y), alone.y - (nxy * p.x + nyy * p.y),
                         alone.z - nzz * p.z);
    Vec acceleration = to_world(&r, felt);
    acceleration.z -= m->gravity;

    State *ds = &rate->state;
    const Vec hw = times(w, all(0.5));
    ds->position = s->velocity;
    ds->qw = -(s->qx * hw.x) - s->qy * hw.y - s->qz * hw.z;
    ds->qx = s->qw * hw.x + s->qy * hw.z - s->qz * hw.y;
    ds->qy = s->qw * hw.y + s->qz * hw.x - s->qx * hw.z;
    ds->qz = s->qw * hw.z + s->qx * hw.y - s->qy * hw.x;
    ds->velocity = acceleration;
    ds->omega = alpha;
#pragma GCC unroll 4
    for (int j = 0; j < ARMS; j++) {
        ds->length[j] = s->rate[j];
        ds->rate[j] = drive[j] - hold[j] * (m->arm[j].cosine * felt.x + m->arm[j].sine * felt.y);
    }
    rate->work = (Work){thrust * v.z + dot(rotor, w), arm_loss, stop_loss, contact_loss, friction_loss,
                        all(0), all(0), to_world(&r, force)};
    if (view) {
        const Vec moving = vec(turning.x + drift_x, turning.y + drift_y, turning.z);
        view->acceleration = acceleration;
        view->specific_force = felt;
        view->mass_centre_velocity = plus(s->velocity, to_world(&r, times(moving, nzz)));
        view->touched_normal = to_world(&r, view->touched_normal);
        /* Eigenvalues of two blocks, sliding in the plane and tumbling out of it, and what couples them. */
        const V det = jxx * jyy - jxy * jxy, inverse = all(1) / (jzz * det);
        const V per_z = det * inverse, per = jzz * inverse;
        const V mid = all(0.5) * per * (jyy * grip_xx + jxx * grip_yy + (jxy + jxy) * grip_xy);
        const V apart = mid * mid - per * (grip_xx * grip_yy - grip_xy * grip_xy);
        const V tumbling = mid + root(positive(apart));
        const V in_plane = grip_all * nzz + grip_z * per_z + grip_arm;
        const V lean = lean_all * nzz + lean_z * per_z + lean_arm;
        const V across = (grip_all - lean_all) * nzz + tumbling, half = all(0.5) * (in_plane - across);
        view->friction_rate = all(0.5) * (in_plane + across) + root(half * half + lean * across);
        const V per_inertia = larger(per * larger(jxx, jyy), per_z);
        const V as_one_body = nzz + farthest * farthest * per_inertia;
        view->contact_rate = root(press_k * as_one_body + arm_k) + (press_c * as_one_body + arm_c);
        const Vec falling = minus(felt, vec(r.z.x * m->gravity, r.z.y * m->gravity, r.z.z * m->gravity));
#pragma GCC unroll 4
        for (int j = 0; j < ARMS; j++) {
            const Arm *a = &m->arm[j];
            const V ddl = ds->rate[j], px = rub_x[j], py = rub_y[j];
            view->unbalance[j] = a->mass * ddl + a->damping * s->rate[j];
            Vec change = vec(falling.x + a->cosine * ddl - alpha.z * py, falling.y + a->sine * ddl + alpha.z * px,
                             falling.z + alpha.x * py - alpha.y * px);
            change = minus(change, times(n, dot(change, n)));
            view->slip_rate = larger(view->slip_rate, dot(change, change) * (per_speed[j] * per_speed[j]));
        }
        view->slip_rate = root(view->slip_rate);
    }
}

/* The record after one more instant, with the next step and phase decided. */
INLINE void observe(const Model *m, const Motion *x, const View *v, Record *k)
{
    const State *s = &x->state;
    const V zero = all(0), one = all(1);
    V touching = zero, unsettled = zero, reach = zero, quickest = zero;
    M jumped = zero != zero;
#pragma GCC unroll 4
    for (int j = 0; j < ARMS; j++) {
        touching = larger(touching, v->touching[j]);
        reach = larger(reach, m->arm[j].length + m->arm[j].cage_radius);
        const V away = v->unbalance[j], rate = s->rate[j];
        quickest = larger(quickest, larger(rate, -rate));
        const V most = m->arm[j].stiffness * m->arm_tolerance;
        const M busy = (away * away > most * most)
                     | (rate * rate > m->rate_tolerance * m->rate_tolerance);
        unsettled = larger(unsettled, sel(busy, m->arm[j].compliance, zero));
        jumped |= v->touching[j] != k->arm_touching[j];
        k->arm_contacts[j] += one_if(v->touching[j] > k->arm_touching[j]);
        k->arm_touching[j] = v->touching[j];
    }
    const M in_touch = touching > zero;
    const M began = touching > k->touching, ended = touching < k->touching;
    const M first = began & (k->contacts == zero), touched_before = k->touch_time >= zero;
    const V length = norm(v->touched_normal);
    k->inward = either(first, times(v->touched_normal, one / sel(length > zero, length, one)), k->inward);
    const V depth = dot(k->inward, s->position), speed = dot(k->inward, s->velocity);
    const V centre_speed = dot(k->inward, v->mass_centre_velocity);
    k->touch_depth = sel(first, depth, k->touch_depth);
    k->touch_time = sel(first, k->time, k->touch_time);
    k->touch_speed = sel(first, speed, k->touch_speed);
    k->touch_mass_centre_speed = sel(first, centre_speed, k->touch_mass_centre_speed);

    const V phase = sel(in_touch, one, sel(unsettled > zero, k->phase, zero));
    k->lock = one_if((phase < k->phase) & (m->hybrid > zero));
    k->last_touch_time = sel(in_touch, k->time, k->last_touch_time);
    const M over = (phase == zero) & (k->time - k->last_touch_time > m->dwell);
    const V open = sel(in_touch, one, sel(over, zero, k->impact_open));
    k->impacts += one_if(open > k->impact_open);
    k->impact_open = open;
    const M of_first = (k->impacts == one) & (open > zero), leaves = ended & of_first;
    const M ahead = (k->impacts == one) & (k->return_time < zero) & touched_before;
    const V past = depth - k->touch_depth;
    const M returns = ahead & (past <= all(LANDED)) & (speed < zero);

    const M within = (k->impacts == one) & (phase == one);
    const Crossing soonest = sooner(v->crossing, crossing(past, sel(ahead, speed, all(0))));
    V landing = soonest.distance / soonest.speed;
    landing = sel(landing > m->impact_step, landing - all(0.5) * m->impact_step, landing);
    const M pressed = in_touch | (v->stopped > zero);
    const V shortest = all(SHORTEST) * m->impact_step;
    const M sliding = (phase > zero) | (m->hybrid == zero);
    V step = sel(sliding, sel(pressed, m->impact_step, m->settle_step), m->free_step);
    step = smaller(step, larger(landing, shortest));
    /* No point moves faster than this, so no cage can touch unnoticed within the step. */
    const V fastest = norm(s->velocity) + reach * norm(s->omega);
    V stiff = larger(v->contact_rate * all(1 / CONTACT_SHARE), v->slip_rate * all(1 / SLIP_SHARE));
    stiff = larger(larger(stiff, v->friction_rate * all(1 / FRICTION_SHARE)), one);
    const V haste = larger(fastest + quickest, all(TINY)), both = one / (haste * stiff);
    step = smaller(step, larger(v->nearest * (stiff * both), m->impact_step));
    step = smaller(step, larger(haste * both, shortest));
    const V left = m->until - k->time;
    const M finished = left <= all(1e-12), flies = k->status == zero;
    const M halted = finished | (phase != k->phase) | (k->status != zero);
    step = sel(halted, zero, smaller(step, left));

    /* Peaks between instants: vertices of parabolas through the last three. */
    const V samples[3] = {norm(v->acceleration), norm(v->specific_force), v->largest_normal};
    const M smooth = (k->step > zero) & ~jumped;
    const M alike = (k->recent_step > all(0.1) * k->step) & (k->step > all(0.1) * k->recent_step);
    const M usable = smooth & alike;
    const V before = sel(usable, k->recent_step, one), after = sel(usable, k->step, one);
    const V shared = one / (after * before * (after + before));
    V peak[3], when = k->time;
#pragma GCC unroll 3
    for (int i = 2; i >= 0; i--) {
        const V middle = k->latest[i];
        const V rise = middle - k->earlier[i], fall = samples[i] - middle;
        const V slope = rise * (after * after) + fall * (before * before);
        const M summit = usable & (rise > zero) & (fall <= zero);
        const V offset = all(-0.5) * slope / sel(summit, fall * before - rise * after, -one);
        peak[i] = sel(summit, middle + all(0.5) * slope * shared * offset, samples[i]);
        when = k->time + sel(summit, offset - after, zero);
        k->earlier[i] = middle;
        k->latest[i] = samples[i];
    }
    k->recent_step = sel(smooth, k->step, zero);
    const V a = peak[0], felt = peak[1], normal = peak[2], spin = norm(s->omega);
    const M harder = within & (a > k->impact_peak_acceleration);
    k->impact_peak_acceleration_time = sel(harder, when, k->impact_peak_acceleration_time);
    k->impact_peak_acceleration = sel(harder, a, k->impact_peak_acceleration);
#define GROWN(field, counts, value) k->field = sel((counts) & ((value) > k->field), (value), k->field)
    GROWN(impact_peak_specific_force, within, felt);
    GROWN(impact_peak_angular_rate, within, spin);
    GROWN(impact_peak_normal_force, within, normal);
    GROWN(impact_penetration, within, v->deepest);
    GROWN(impact_arm_stroke, within, v->most_compressed);
    GROWN(impact_arm_extension, within, -v->least_compressed);
    GROWN(travel, of_first & (in_touch | ended), past);
    k->peak_acceleration_time = sel(a > k->peak_acceleration, when, k->peak_acceleration_time);
    k->peak_acceleration = larger(a, k->peak_acceleration);
    k->peak_specific_force = larger(felt, k->peak_specific_force);
    k->peak_angular_rate = larger(spin, k->peak_angular_rate);
    k->peak_normal_force = larger(normal, k->peak_normal_force);
    k->peak_penetration = larger(v->deepest, k->peak_penetration);
    k->peak_compression = larger(v->most_compressed, k->peak_compression);
    k->peak_extension = larger(-v->least_compressed, k->peak_extension);
    k->separation_time = sel(leaves, k->time, k->separation_time);
    k->separation_speed = sel(leaves, speed, k->separation_speed);
    k->separation_mass_centre_speed = sel(leaves, centre_speed, k->separation_mass_centre_speed);
    k->return_time = sel(returns, k->time, k->return_time);
    k->return_speed = sel(returns, speed, k->return_speed);
    k->bottomed_time = sel((v->bottomed > zero) & (k->bottomed_time < zero), k->time, k->bottomed_time);
    k->ground_time = sel((v->on_ground > zero) & (k->ground_time < zero), k->time, k->ground_time);
    k->contacts += one_if(began);
    k->touching = touching;
    k->contact_duration += sel(in_touch, step, zero);
    k->steps += one_if(step > zero);
    k->status = sel(flies & finished, all(FINISHED), k->status);
    k->phase = phase;
    k->step = step;
}

/* One lane as numbers, for rare events. */
static void out_of_lane(const void *from, int rows, int lane, double *to)
{
    for (int i = 0; i < rows; i++)
        to[i] = LANE(((const V *)from)[i], lane);
}

typedef struct { double x, y, z; } D3;
static D3 d3(double x, double y, double z) { return (D3){x, y, z}; }
static D3 add3(D3 a, D3 b) { return d3(a.x + b.x, a.y + b.y, a.z + b.z); }
static D3 sub3(D3 a, D3 b) { return d3(a.x - b.x, a.y - b.y, a.z - b.z); }
static D3 mul3(D3 a, double s) { return d3(a.x * s, a.y * s, a.z * s); }
static double dot3(D3 a, D3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static D3 cross3(D3 a, D3 b)
{
    return d3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static D3 transform(double a[3][3], D3 v)
{
    return d3(a[0][0] * v.x + a[0][1] * v.y + a[0][2] * v.z, a[1][0] * v.x + a[1][1] * v.y + a[1][2] * v.z,
              a[2][0] * v.x + a[2][1] * v.y + a[2][2] * v.z);
}
static D3 solve3(double a[3][3], D3 b)
{
    D3 r0 = d3(a[0][0], a[0][1], a[0][2]), r1 = d3(a[1][0], a[1][1], a[1][2]);
    D3 r2 = d3(a[2][0], a[2][1], a[2][2]);
    double det = dot3(r0, cross3(r1, r2));
    D3 sum = add3(add3(mul3(cross3(r1, r2), b.x), mul3(cross3(r2, r0), b.y)), mul3(cross3(r0, r1), b.z));
    return mul3(sum, 1 / det);
}

typedef struct { double mass, inverse_mass, inertia[9], arm[ARMS][ROWS(Arm)]; } Plain; /* the head of Model */
typedef struct { D3 position; double q[4]; D3 velocity, omega; double length[ARMS], rate[ARMS]; } Plainly;
typedef struct { D3 first, drift; double second[3][3]; } Spread;
enum { COSINE, SINE, MASS, INVERSE, STIFFNESS, DAMPING, LENGTH, SHORTEST_, STOP, STOP_D, COMPLIANCE };

static Spread spread(const Plain *m, const Plainly *s)
{
    Spread p;
    memset(&p, 0, sizeof p);
    for (int i = 0; i < 9; i++)
        p.second[i / 3][i % 3] = m->inertia[i];
#pragma GCC unroll 4
    for (int j = 0; j < ARMS; j++) {
        const double *a = m->arm[j], c = a[COSINE], q = a[SINE], ml = a[MASS] * s->length[j];
        const double mll = ml * s->length[j], md = a[MASS] * s->rate[j];
        p.first = add3(p.first, d3(ml * c, ml * q, 0));
        p.drift = add3(p.drift, d3(md * c, md * q, 0));
        p.second[0][0] += mll * q * q;
        p.second[1][1] += mll * c * c;
        p.second[2][2] += mll;
        p.second[0][1] -= mll * c * q;
        p.second[1][0] -= mll * c * q;
    }
    return p;
}

static double positive_square(double x) { return x > 0 ? x * x : 0; }

/* Kinetic, gravity, spring and stop energy. */
static double energy(const Plain *m, const Plainly *s, const D3 rows[3], double gravity)
{
    const Spread p = spread(m, s);
    const D3 body_velocity = add3(add3(mul3(rows[0], s->velocity.x), mul3(rows[1], s->velocity.y)),
                                  mul3(rows[2], s->velocity.z));
    double e = 0.5 * m->mass * dot3(body_velocity, body_velocity);
    e += dot3(body_velocity, add3(cross3(s->omega, p.first), p.drift));
    e += 0.5 * dot3(s->omega, transform((double(*)[3])p.second, s->omega));
    e += gravity * (m->mass * s->position.z + dot3(rows[2], p.first));
#pragma GCC unroll 4
    for (int j = 0; j < ARMS; j++) {
        const double *a = m->arm[j], off = a[LENGTH] - s->length[j];
        e += 0.5 * a[MASS] * s->rate[j] * s->rate[j] + 0.5 * a[COMPLIANCE] * a[STIFFNESS] * off * off;
        e += 0.5 * a[COMPLIANCE] * a[STOP]
           * (positive_square(a[SHORTEST_] - s->length[j]) + positive_square(-off));
    }
    return e;
}

/* Settled arms stop where they are: momentum stays, the loss is booked. */
static __attribute__((noinline)) void lock(const Model *model, Motion *x, int lane)
{
    Plain m;
    Plainly s;
    double values[ROWS(State)];
    out_of_lane(model, sizeof(Plain) / 8, lane, (double *)&m);
    out_of_lane(&x->state, ROWS(State), lane, values);
    memcpy(&s, values, sizeof s);
    const double w = s.q[0], i = s.q[1], j = s.q[2], k = s.q[3], g = LANE(model->gravity, lane);
    const D3 r[3] = {
        {1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j)},
        {2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i)},
        {2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j)},
    };
#define WORLD(a) d3(dot3(r[0], a), dot3(r[1], a), dot3(r[2], a))
    const double before = energy(&m, &s, r, g);
    Spread p = spread(&m, &s);
    const D3 centre = mul3(p.first, 1 / m.mass);
    const D3 relative = add3(cross3(s.omega, centre), mul3(p.drift, 1 / m.mass));
    const D3 spin = sub3(transform(p.second, s.omega), mul3(cross3(centre, relative), m.mass));
    const D3 velocity = add3(s.velocity, WORLD(relative));
    for (int a = 0; a < ARMS; a++)
        s.rate[a] = 0;
    const D3 c = centre;
    const double cc[3] = {c.x, c.y, c.z};
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            p.second[a][b] -= m.mass * ((a == b ? dot3(c, c) : 0) - cc[a] * cc[b]);
    s.omega = solve3(p.second, spin);
    s.velocity = sub3(velocity, WORLD(cross3(s.omega, c)));
    memcpy(values, &s, sizeof s);
    for (int a = 0; a < ROWS(State); a++)
        LANE(((V *)&x->state)[a], lane) = values[a];
    LANE(x->work.settling, lane) += before - energy(&m, &s, r, g);
}

/* Fly one group to its end, at most `budget` steps. */
static void fly_group(const Model *m, Motion *x, Record *k, long budget)
{
    static const double reach[4] = {0, 0.5, 0.5, 1}, weight[4] = {1, 2, 2, 1};
    Motion rate, total;
    State here;
    View view;
    while (budget--) {
        V released = one_if((m->hybrid == all(0)) | (k->phase > all(0)));
        rates(m, &x->state, released, NULL, &rate, &view);
        observe(m, x, &view, k);
        total = rate;
        released = one_if((m->hybrid == all(0)) | (k->phase > all(0)));
#pragma GCC unroll 1
        for (int stage = 1; stage < 4; stage++) {
            const V h = k->step * reach[stage];
            const V *from = (V *)&x->state, *slope = (V *)&rate.state;
            for (int i = 0; i < ROWS(State); i++)
                ((V *)&here)[i] = from[i] + h * slope[i];
            rates(m, &here, released, k->arm_touching, &rate, NULL);
            for (int i = 0; i < ROWS(Motion); i++)
                ((V *)&total)[i] += weight[stage] * ((V *)&rate)[i];
        }
        Motion next;
        const V h = k->step * (1.0 / 6.0);
        V size = all(0);
        for (int i = 0; i < ROWS(Motion); i++) {
            const V y = ((V *)x)[i] + h * ((V *)&total)[i];
            ((V *)&next)[i] = y;
            size += y * y;
        }
        State *s = &next.state;
        const V e = all(1) - (s->qw * s->qw + s->qx * s->qx + s->qy * s->qy + s->qz * s->qz);
        const V scale = all(1) + e * (all(0.5) + all(0.375) * e);
        s->qw *= scale;
        s->qx *= scale;
        s->qy *= scale;
        s->qz *= scale;
        const M good = size < all(DIVERGED);
        for (int i = 0; i < ROWS(Motion); i++)
            ((V *)x)[i] = sel(good & (k->step > all(0)), ((V *)&next)[i], ((V *)x)[i]);
        k->time += sel(good, k->step, all(0));
        k->status = sel(good, k->status, all(NOT_FINITE));
        int running = 0, locking = 0;
        for (int i = 0; i < LANES; i++) {
            const int flies = LANE(k->status, i) == FLYING;
            running += flies;
            locking += flies && LANE(k->lock, i) != 0;
        }
        if (locking)
            for (int i = 0; i < LANES; i++)
                if (LANE(k->lock, i) != 0 && LANE(k->status, i) == FLYING)
                    lock(m, x, i);
        if (!running)
            break;
    }
}

int lanes(void) { return LANES; }
int input_rows(void) { return ROWS(Model) + ROWS(State); }
int output_rows(void) { return ROWS(Motion) + ROWS(Record); }

/* Fly flights first to last: `input` holds model and start state, `output` takes motion and record,
 * one flight a row.  A group that is not full repeats its last flight. */
void fly(const double *input, double *output, long first, long last, long budget)
{
    for (long group = first; group < last; group += LANES) {
        Model model;
        Motion motion;
        Record record;
        memset(&motion, 0, sizeof motion);
        memset(&record, 0, sizeof record);
        for (int lane = 0; lane < LANES; lane++) {
            const long flight = group + lane < last ? group + lane : last - 1;
            const double *row = input + flight * (ROWS(Model) + ROWS(State));
            for (int i = 0; i < ROWS(Model); i++)
                LANE(((V *)&model)[i], lane) = row[i];
            for (int i = 0; i < ROWS(State); i++)
                LANE(((V *)&motion.state)[i], lane) = row[ROWS(Model) + i];
        }
        record.last_touch_time = record.touch_time = record.separation_time = all(-1);
        record.return_time = record.bottomed_time = record.ground_time = all(-1);
        record.impact_peak_acceleration_time = all(-1);
        fly_group(&model, &motion, &record, budget);
        for (int lane = 0; lane < LANES && group + lane < last; lane++) {
            double *row = output + (group + lane) * (ROWS(Motion) + ROWS(Record));
            out_of_lane(&motion, ROWS(Motion), lane, row);
            out_of_lane(&record, ROWS(Record), lane, row + ROWS(Motion));
        }
    }
}
