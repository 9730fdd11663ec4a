/* dashpot as the dampers of a MuJoCo model, in its passive-force callback, at 1 ms: a quarter car and a vehicle.
 *
 *   pip install mujoco                       # brings headers and library
 *   M=$(python3 -c 'import mujoco,os;print(os.path.dirname(mujoco.__file__))')
 *   cc -O2 -I include -I vi-crt-bridge/bridge -I $M/include vi-crt-bridge/mujoco/vehicle.c \
 *      BRIDGE_SOURCES target/lib/libdashpot.a $M/libmujoco.so.* -Wl,-rpath,$M -lm -o vehicle
 *   ./vehicle damper.toml curve.toml         # the identified model, and an FV curve to compare with
 *   ./vehicle damper.toml curve.toml semi_active.toml   # and a damper over a setting: soft, hard, and under a skyhook controller
 *
 * MuJoCo applies the callback's forces explicitly with every integrator. It may call the callback several times at the same
 * time (mj_forward, a Jacobian), so the dampers advance only if the time has advanced.
 *
 * A controller writes the setting of each damper into `userdata` of MuJoCo's data, one number per corner. The setting is a
 * current or clicks, in the unit of the model file. In a run without a controller the dampers keep their start setting.
 *
 * Heights are relative to the static position and gravity is zero, so that the springs need no preload. */
#include "dashpot_bridge.h"
#include <math.h>
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DT 1e-3
#define TAU 6.283185307179586476925286766559
#define BODY 350.0
#define WHEEL 40.0
#define SPRING 24e3
#define TYRE 220e3

static const char QUARTER[] =
    "<mujoco><option timestep='0.001' gravity='0 0 0'><flag contact='disable'/></option><worldbody>"
    "<body name='chassis'><joint name='heave' type='slide' axis='0 0 1'/>"
    "<inertial pos='0 0 0' mass='350' diaginertia='1 1 1'/>"
    "<body name='L1'><joint name='L1' type='slide' axis='0 0 1' stiffness='24000'/>"
    "<inertial pos='0 0 0' mass='40' diaginertia='1 1 1'/></body>"
    "</body></worldbody></mujoco>";

#define CORNER(name, x, y)                                                                                             \
    "<body name='" name "' pos='" x " " y " 0'><joint name='" name "' type='slide' axis='0 0 1' stiffness='24000'/>"   \
    "<inertial pos='0 0 0' mass='40' diaginertia='1 1 1'/></body>"

static const char VEHICLE[] =
    "<mujoco><size nuserdata='4'/><option timestep='0.001' gravity='0 0 0'><flag contact='disable'/></option><worldbody>"
    "<body name='chassis'><joint name='heave' type='slide' axis='0 0 1'/><joint name='roll' type='hinge' axis='1 0 0'/>"
    "<joint name='pitch' type='hinge' axis='0 1 0'/><inertial pos='0 0 0' mass='1400' diaginertia='500 2200 2500'/>"
    CORNER("L1", "1.2", "0.78") CORNER("R1", "1.2", "-0.78") CORNER("L2", "-1.5", "0.78") CORNER("R2", "-1.5", "-0.78")
    "</body></worldbody></mujoco>";

/* Data of the callback. They are static, because MuJoCo passes no user pointer to it. */
static struct {
    dashpot_bridge *bridge;
    int corners, joint[4], body[4];
    dashpot_corner_output out[4];
    double rest[4], time;
    int has_setting;
} car;

/* Returns the road height at a corner, m: a bump 40 mm high on the left and 20 mm on the right, passed in 60 ms. The rear
 * axle follows the front axle by 324 ms. */
static double road(int corner, double time)
{
    double t = time - 0.2 - (corner >= 2 ? 0.324 : 0.0);
    double height = corner % 2 ? 0.01 : 0.02;

    return t > 0.0 && t < 0.06 ? height * (1.0 - cos(TAU * t / 0.06)) : 0.0;
}

static void dampers(const mjModel *m, mjData *d)
{
    dashpot_corner_input in[4];
    int i;

    memset(in, 0, sizeof in);
    for (i = 0; i < car.corners; i++) {
        /* The wheel's joint is positive upward, that is, in compression. */
        in[i].jounce = d->qpos[m->jnt_qposadr[car.joint[i]]];
        in[i].jounce_rate = d->qvel[m->jnt_dofadr[car.joint[i]]];
        in[i].known = DASHPOT_CORNER_KNOWS_JOUNCE;
        if (car.has_setting) {
            in[i].setting = d->userdata[i];
            in[i].known |= DASHPOT_CORNER_KNOWS_SETTING;
        }
    }
    if (d->time > car.time) {
        dashpot_bridge_step(car.bridge, d->time - car.time, in, car.out);
        car.time = d->time;
    }
    for (i = 0; i < car.corners; i++) {
        const mjtNum *at = d->xipos + 3 * car.body[i];
        mjtNum lift[3] = {0, 0, TYRE * (road(i, d->time) - at[2])}, none[3] = {0, 0, 0};

        d->qfrc_passive[m->jnt_dofadr[car.joint[i]]] -= car.out[i].force - car.rest[i];
        mj_applyFT(m, d, lift, none, at, car.body[i], d->qfrc_passive);
    }
}

static dashpot_bridge *bridge(int corners, const char *file)
{
    const char *files[4] = {file, file, file, file};
    dashpot_bridge_fault fault;
    dashpot_bridge *made = dashpot_bridge_create((uint32_t)corners, files, NULL, &fault);

    if (!made) {
        fprintf(stderr, "%s\n", fault.text);
        exit(1);
    }
    return made;
}

static void begin(int corners, const char *file)
{
    dashpot_corner_input in[4];
    int i;

    memset(&car, 0, sizeof car);
    memset(in, 0, sizeof in);
    car.corners = corners;
    car.bridge = bridge(corners, file);
    dashpot_bridge_init(car.bridge, in, car.out);
    for (i = 0; i < corners; i++)
        car.rest[i] = car.out[i].force;
}

static mjModel *load(const char *xml)
{
    static const char *const names[4] = {"L1", "R1", "L2", "R2"};
    char error[500] = "";
    mjVFS vfs;
    mjModel *m;
    int i;

    mj_defaultVFS(&vfs);
    mj_addBufferVFS(&vfs, "car.xml", xml, (int)strlen(xml));
    m = mj_loadXML("car.xml", &vfs, error, sizeof error);
    mj_deleteVFS(&vfs);
    if (!m) {
        fprintf(stderr, "%s\n", error);
        exit(1);
    }
    for (i = 0; i < car.corners; i++) {
        car.joint[i] = mj_name2id(m, mjOBJ_JOINT, names[i]);
        car.body[i] = mj_name2id(m, mjOBJ_BODY, names[i]);
    }
    return m;
}

/* Compares the quarter car in MuJoCo with a quarter car that this function integrates itself. Returns the largest difference
 * of the body's height divided by the height's peak. */
static double quarter(const char *file)
{
    mjModel *m;
    mjData *d;
    dashpot_bridge *by_hand = bridge(1, file);
    dashpot_corner_input in = {0};
    dashpot_corner_output out;
    double z[2] = {0, 0}, v[2] = {0, 0}, rest, worst = 0.0, peak = 0.0;
    int k;

    begin(1, file);
    m = load(QUARTER);
    d = mj_makeData(m);
    in.known = DASHPOT_CORNER_KNOWS_JOUNCE;
    dashpot_bridge_init(by_hand, &in, &out);
    rest = out.force;
    for (k = 0; k < 2000; k++) {
        double push, spring, tyre;

        mj_step(m, d);
        if (k) {
            in.jounce = z[1] - z[0];
            in.jounce_rate = v[1] - v[0];
            dashpot_bridge_step(by_hand, DT, &in, &out);
        }
        push = out.force - rest;
        spring = SPRING * (z[1] - z[0]);
        tyre = TYRE * (road(0, k * DT) - z[1]);
        v[0] += DT * (spring + push) / BODY;
        v[1] += DT * (tyre - spring - push) / WHEEL;
        z[0] += DT * v[0];
        z[1] += DT * v[1];
        worst = fmax(worst, fabs(d->qpos[0] - z[0]));
        peak = fmax(peak, fabs(z[0]));
    }
    printf("quarter car: body peak %.4f mm, MuJoCo and by hand differ by %.2e mm\n", 1e3 * peak, 1e3 * worst);
    mj_deleteData(d);
    mj_deleteModel(m);
    dashpot_bridge_destroy(by_hand);
    dashpot_bridge_destroy(car.bridge);
    return worst / peak;
}

/* Runs a vehicle over the bump with an on-off skyhook controller; soft = hard is a constant setting. Returns the heave
 * acceleration, m/s^2 rms. */
static double semi_active(const char *file, const char *name, double soft, double hard)
{
    mjModel *m;
    mjData *d;
    dashpot_corner_input in[4];
    double acceleration = 0.0;
    int k, i;

    begin(4, file);
    memset(in, 0, sizeof in);
    car.has_setting = 1;
    m = load(VEHICLE);
    d = mj_makeData(m);
    for (i = 0; i < 4; i++) {
        in[i].setting = d->userdata[i] = soft;
        in[i].known = DASHPOT_CORNER_KNOWS_SETTING;
    }
    dashpot_bridge_init(car.bridge, in, car.out);
    for (i = 0; i < 4; i++)
        car.rest[i] = car.out[i].force;
    for (k = 0; k < 3000; k++) {
        for (i = 0; i < 4; i++) {
            /* The damper is hard if its force opposes the body's motion. The joint is positive in compression, so the sign of its
             * rate is reversed to get extension. */
            double rate = -d->qvel[m->jnt_dofadr[car.joint[i]]];

            d->userdata[i] = d->qvel[0] * rate > 0.0 ? hard : soft;
        }
        mj_step(m, d);
        acceleration += d->qacc[0] * d->qacc[0];
    }
    acceleration = sqrt(acceleration / 3000.0);
    printf("semi-active, %s: heave acceleration %.4f m/s^2 rms\n", name, acceleration);
    mj_deleteData(d);
    mj_deleteModel(m);
    dashpot_bridge_destroy(car.bridge);
    return acceleration;
}

static void vehicle(const char *file, const char *name)
{
    mjModel *m;
    mjData *d;
    double heave = 0.0, roll = 0.0, acceleration = 0.0, force = 0.0, energy = 0.0;
    int k, i;

    begin(4, file);
    m = load(VEHICLE);
    d = mj_makeData(m);
    for (k = 0; k < 3000; k++) {
        mj_step(m, d);
        heave = fmax(heave, fabs(d->qpos[0]));
        roll = fmax(roll, fabs(d->qpos[1]));
        acceleration += d->qacc[0] * d->qacc[0];
        for (i = 0; i < 4; i++) {
            double push = car.out[i].force - car.rest[i];
            force = fmax(force, fabs(push));
            energy += push * d->qvel[3 + i] * DT;
        }
    }
    printf("vehicle, %s: heave %.3f mm, roll %.3f deg, heave acceleration %.4f m/s^2 rms, largest damper force %.0f N, "
           "dissipated %.2f J\n",
           name, 1e3 * heave, roll * 360.0 / TAU, sqrt(acceleration / 3000.0), force, energy);
    mj_deleteData(d);
    mj_deleteModel(m);
    dashpot_bridge_destroy(car.bridge);
    if (!(energy > 0.0 && heave > 1e-3 && heave < 0.1))
        exit(1);
}

int main(int argc, char **argv)
{
    if (argc != 3 && argc != 4) {
        fprintf(stderr, "usage: %s MODEL CURVE [MODEL_OVER_A_SETTING]\n", argv[0]);
        return 2;
    }
    mjcb_passive = dampers;
    if (!(quarter(argv[1]) < 1e-6))
        return 1;
    vehicle(argv[1], "model");
    vehicle(argv[2], "FV curve");
    if (argc == 4) {
        double hard = semi_active(argv[3], "hard", 1.6, 1.6), sky;

        semi_active(argv[3], "soft", 0.0, 0.0);
        sky = semi_active(argv[3], "skyhook", 0.0, 1.6);
        if (!(sky < hard))
            return 1;
    }
    return 0;
}
