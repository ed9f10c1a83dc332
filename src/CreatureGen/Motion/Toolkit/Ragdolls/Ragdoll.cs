using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Motion.Toolkit.Poses;
using CreatureGen.Motion.Toolkit.Ragdolls;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Lets a creature go limp, fall and lie. Nothing is allocated.</summary>
/// <remarks>
/// <para>Going limp: <see cref="Start"/> takes over pose and velocities of the motion, <see cref="Advance"/> lets time pass, <see cref="Show"/> writes the pose. Getting up: take
/// <see cref="PlaceUnder"/> as the creature's new place, write the lying pose relative to it once more, and fade from it to the motion with <see cref="CrossFade"/> and <see cref="PoseBlend"/>.</para>
/// <para>The pose is made of rotations alone, each within its joint's limit, so bones keep their length and knees do not bend back even in the midst of an impact. Joints that the motion
/// had slid along their bones, as those of folded wings, go back to their places slowly.</para>
/// </remarks>
public static class Ragdoll
{
    /// <summary>Length of a substep, seconds.</summary>
    public const float Substep = 1f / 480f;

    /// <summary>More than this is not simulated in one call, seconds: the ragdoll falls in slow motion rather than take ever longer to compute.</summary>
    public const float LongestStep = 0.25f;

    private const int Rounds = 2;
    private const float AllowanceRate = 2f;
    private const float CalmSeconds = 0.5f;
    private const float CalmFraction = 0.012f;
    private const float TurningArm = 0.1f;
    private const float TiredFraction = 4f;
    private const float TiredDamping = 3f;
    private const float RestlessFraction = 20f;
    private const float RestlessSeconds = 3f;

    /// <summary>Seconds of restlessness that a second of fast motion makes forgotten: who is shaken by his own joints has faster moments too.</summary>
    private const float Forgetting = 4f;

    /// <summary>Takes over from a motion.</summary>
    /// <param name="rig">The parts.</param>
    /// <param name="state">Made for this rig.</param>
    /// <param name="root">Where the creature is.</param>
    /// <param name="model">Its pose in model space.</param>
    /// <param name="rootBefore">Where it was a step before.</param>
    /// <param name="modelBefore">Its pose then; the same again to start from a standstill.</param>
    /// <param name="seconds">Time between the two; 0 to start from a standstill.</param>
    /// <param name="ground">What it will fall on: parts that are in it already are let out slowly.</param>
    /// <exception cref="ArgumentException">The state is of another rig, a pose is not as long as the skeleton, or a number is not finite.</exception>
    public static void Start<TGround>(RagdollRig rig, RagdollState state, in RootPlace root, in Pose model, in RootPlace rootBefore, in Pose modelBefore, float seconds, TGround ground)
        where TGround : IGround
    {
        Require(rig, state, model);
        model.Require(rig.Skeleton);
        modelBefore.Require(rig.Skeleton);
        root.Require(nameof(root));
        rootBefore.Require(nameof(rootBefore));
        Finite.RequireStep(seconds);
        state.Anchor = root.Position;
        state.Scale = root.Scale;
        state.Debt = 0f;
        state.Calm = 0f;
        state.Restless = 0f;
        state.Speed = 0f;
        state.IsActive = true;
        state.IsAsleep = false;
        float perSecond = seconds > 0f ? 1f / seconds : 0f;
        ReadOnlySpan<RagdollPart> parts = rig.Parts;
        for (int i = 0; i < parts.Length; i++)
        {
            Locate(parts[i], root, model, out Vector3 now, out Quaternion rotation);
            Locate(parts[i], rootBefore, modelBefore, out Vector3 before, out Quaternion rotationBefore);
            if (!Finite.Is(now) || !Finite.Is(rotation) || !Finite.Is(before) || !Finite.Is(rotationBefore))
            {
                throw PoseCheck.NotFinite(parts[i].Joint);
            }

            state.Positions[i] = now - state.Anchor;
            state.Rotations[i] = Rotation.Normalize(rotation);
            state.Velocities[i] = (now - before) * perSecond;
            state.Spins[i] = Spin(rotation, rotationBefore) * perSecond;
            state.PastPositions[i] = state.Positions[i];
            state.PastRotations[i] = state.Rotations[i];
            state.Targets[i] = Quaternion.Identity;
            state.Tones[i] = 0f;
            state.Excesses[i] = 0f;
            state.Slides[i] = Vector3.Zero;
            if (i > 0)
            {
                state.Slides[i] = Rotation.Rotate(Rotation.Inverse(model.Rotations[parts[parts[i].Parent].Joint]), model.Positions[parts[i].Joint] - Place(parts, i, Vector3.Zero, model));
                Quaternion carrier = Rotation.Multiply(state.Rotations[parts[i].Parent], parts[i].RestInParent);
                state.Excesses[i] = SwingTwistLimit.Excess(Rotation.Multiply(Rotation.Inverse(carrier), state.Rotations[i]), parts[i].Limit);
            }
        }

        RagdollCollision.Start(state);
        Vector3 up = Rotation.Rotate(root.Rotation, Vector3.UnitY);
        ReadOnlySpan<RagdollContact> contacts = rig.Contacts;
        for (int c = 0; c < contacts.Length; c++)
        {
            RagdollContact contact = contacts[c];
            Vector3 centre = state.Positions[contact.Part] + (Rotation.Rotate(state.Rotations[contact.Part], contact.Place) * state.Scale);
            state.Allowances[c] = RagdollFloor.TryFind(ground, state.Anchor + centre, contact.Radius * state.Scale, rig.Size * state.Scale, up, out GroundHit hit)
                ? Math.Max(0f, contact.Radius - (Vec.Dot(centre - (hit.Point - state.Anchor), hit.Normal) / state.Scale))
                : 0f;
        }
    }

    /// <summary>Gives muscles a pose to pull to, for <see cref="RagdollSettings.Tone"/>.</summary>
    /// <param name="rig">The parts.</param>
    /// <param name="state">Made for this rig.</param>
    /// <param name="model">The pose in model space.</param>
    /// <exception cref="ArgumentException">The state is of another rig, or the pose is not as long as the skeleton.</exception>
    public static void Aim(RagdollRig rig, RagdollState state, in Pose model)
    {
        Require(rig, state, model);
        ReadOnlySpan<RagdollPart> parts = rig.Parts;
        for (int i = 1; i < parts.Length; i++)
        {
            Quaternion carrier = Rotation.Multiply(model.Rotations[parts[parts[i].Parent].Joint], parts[i].RestInParent);
            Quaternion turn = Rotation.Multiply(Rotation.Inverse(carrier), model.Rotations[parts[i].Joint]);
            if (!Finite.Is(turn))
            {
                throw PoseCheck.NotFinite(parts[i].Joint);
            }

            state.Targets[i] = Rotation.Normalize(turn);
        }
    }

    /// <summary>Lets time pass.</summary>
    /// <param name="rig">The parts.</param>
    /// <param name="state">Started.</param>
    /// <param name="settings">What they are made of.</param>
    /// <param name="ground">What they fall on, felt by rays along gravity; as a structure it costs no virtual call.</param>
    /// <param name="seconds">Not negative.</param>
    /// <exception cref="ArgumentException">The state is of another rig, or the time is negative or not finite.</exception>
    public static void Advance<TGround>(RagdollRig rig, RagdollState state, in RagdollSettings settings, TGround ground, float seconds)
        where TGround : IGround
    {
        RequireSame(rig, state);
        Finite.RequireStep(seconds);
        if (!state.IsActive || state.IsAsleep)
        {
            return;
        }

        state.Debt += Math.Min(seconds, LongestStep);
        float letOut = Damping.Left(AllowanceRate, Substep);
        while (state.Debt >= Substep)
        {
            state.Debt -= Substep;
            RagdollSolver.Advance(state, Tired(rig, state, settings), Substep, Rounds, ground);
            for (int c = 0; c < state.Allowances.Length; c++)
            {
                state.Allowances[c] *= letOut;
            }

            for (int i = 0; i < state.Excesses.Length; i++)
            {
                state.Excesses[i] *= letOut;
                state.Slides[i] *= letOut;
            }

            if (Rests(rig, state, settings))
            {
                break;
            }
        }
    }

    /// <summary>Writes the pose.</summary>
    /// <param name="rig">The parts.</param>
    /// <param name="state">Started.</param>
    /// <param name="root">Where the creature's model space is; it need not follow the parts.</param>
    /// <param name="local">Joints of the parts are turned and in their places on their bones, the first part's goes where it has fallen; all others stay as they are.</param>
    /// <param name="model">The same in model space; all is brought up to date.</param>
    /// <exception cref="ArgumentException">The state is of another rig, or a pose is not as long as the skeleton.</exception>
    public static void Show(RagdollRig rig, RagdollState state, in RootPlace root, in Pose local, in Pose model)
    {
        Require(rig, state, model);
        local.Require(rig.Skeleton);
        root.Require(nameof(root));
        if (!state.IsActive)
        {
            return;
        }

        ReadOnlySpan<RagdollPart> parts = rig.Parts;
        ReadOnlySpan<int> parents = rig.Skeleton.Parents;
        float between = state.IsAsleep ? 1f : state.Debt / Substep;
        Quaternion toModel = Rotation.Inverse(root.Rotation);
        int next = 0;
        for (int j = 0; j < parents.Length; j++)
        {
            if (next < parts.Length && parts[next].Joint == j)
            {
                ref readonly RagdollPart part = ref parts[next];
                Quaternion turned = Rotation.Nlerp(state.PastRotations[next], state.Rotations[next], between);
                Quaternion inModel = Rotation.Multiply(toModel, turned);
                Quaternion toParent = JointRelations.ParentInverse(rig.Skeleton, j, model);
                Quaternion rest = rig.Skeleton.LocalRotations[j];
                Quaternion turn = Rotation.Multiply(Rotation.Inverse(rest), Rotation.Multiply(toParent, inModel));
                local.Rotations[j] = Rotation.Normalize(Rotation.Multiply(rest, RagdollSolver.Bounded(turn, part.Limit, state.Excesses[next])));
                if (next == 0)
                {
                    Vector3 centre = Vec.Lerp(state.PastPositions[0], state.Positions[0], between);
                    Vector3 world = state.Anchor + centre - (Rotation.Rotate(turned, part.Centre) * state.Scale);
                    Vector3 place = root.ToModel(world);
                    local.Positions[j] = parents[j] < 0 ? place : Rotation.Rotate(toParent, place - model.Positions[parents[j]]);
                }
                else
                {
                    local.Positions[j] = Rotation.Rotate(toParent, Place(parts, next, state.Slides[next], model) - model.Positions[parents[j]]);
                }

                next++;
            }

            Subtree.Place(parents[j], j, local, model);
        }
    }

    /// <summary>Where a creature stands that gets up from here: under the first part, facing as the trunk does, upright.</summary>
    /// <param name="rig">The parts.</param>
    /// <param name="state">Started.</param>
    /// <param name="ground">What it lies on, below it along −Y.</param>
    /// <exception cref="ArgumentException">The state is of another rig.</exception>
    public static RootPlace PlaceUnder<TGround>(RagdollRig rig, RagdollState state, TGround ground)
        where TGround : IGround
    {
        RequireSame(rig, state);
        RagdollPart first = rig.Parts[0];
        Vector3 joint = state.Anchor + state.Positions[0] - (Rotation.Rotate(state.Rotations[0], first.Centre) * state.Scale);
        Vector3 rest = rig.Skeleton.ModelPositions[first.Joint];
        Quaternion turned = Rotation.Multiply(state.Rotations[0], Rotation.Inverse(rig.Skeleton.ModelRotations[first.Joint]));
        Vector3 ahead = Rotation.Rotate(turned, Vector3.UnitZ);

        // Standing on its nose or tail it faces where its back or belly does.
        Vector3 flat = new(ahead.X, 0f, ahead.Z);
        if (Vec.LengthSquared(flat) < 0.01f)
        {
            Vector3 up = Rotation.Rotate(turned, Vector3.UnitY);
            flat = new Vector3(up.X, 0f, up.Z) * (ahead.Y > 0f ? -1f : 1f);
        }

        Quaternion facing = Rotation.FromAxisAngle(Vector3.UnitY, PortableMath.Atan2(flat.X, flat.Z));
        Vector3 under = joint - (Rotation.Rotate(facing, new Vector3(rest.X, 0f, rest.Z)) * state.Scale);
        float size = rig.Size * state.Scale;
        float height = ground.Cast(under + (Vector3.UnitY * size), -Vector3.UnitY, 3f * size, out GroundHit hit) ? hit.Point.Y : joint.Y;
        return new RootPlace(new Vector3(under.X, height, under.Z), facing, state.Scale);
    }

    /// <summary>Below this speed a creature has all but come to rest.</summary>
    private static float CalmSpeed(RagdollRig rig, RagdollState state, in RagdollSettings settings) =>
        CalmFraction * (float)Math.Sqrt(rig.Size * state.Scale * Vec.Length(settings.Gravity));

    /// <summary>Slow motion dies faster than fast motion: flesh rolls and rocks badly. So does what still moves seconds after a fall: joints, limits and ground that contradict one another can shake parts or push the whole along for ever.</summary>
    private static RagdollSettings Tired(RagdollRig rig, RagdollState state, in RagdollSettings settings) =>
        state.Speed > TiredFraction * CalmSpeed(rig, state, settings) && state.Restless < RestlessSeconds ? settings : settings.Slowed(TiredDamping * (1f + state.Restless));

    /// <summary>Whether it has been still for long enough to sleep; the longer it has been restless, the more counts as still.</summary>
    private static bool Rests(RagdollRig rig, RagdollState state, in RagdollSettings settings)
    {
        float size = rig.Size * state.Scale;
        float speed = 0f;
        float mass = 0f;
        Vector3 momentum = Vector3.Zero;
        for (int i = 0; i < rig.Count; i++)
        {
            momentum += state.Velocities[i] / rig.Parts[i].InverseMass;
            float turning = Vec.LengthSquared(state.Spins[i]) * TurningArm * TurningArm * size * size;
            speed += (Vec.LengthSquared(state.Velocities[i]) + turning) / rig.Parts[i].InverseMass;
            mass += 1f / rig.Parts[i].InverseMass;
        }

        speed = (float)Math.Sqrt(speed / mass);
        state.Speed = speed;
        float calm = CalmSpeed(rig, state, settings);

        // What shakes in its place, however fast, goes nowhere as a whole.
        state.Restless = Vec.Length(momentum) / mass <= RestlessFraction * calm ? state.Restless + Substep : Math.Max(state.Restless - (Forgetting * Substep), 0f);
        float restless = Math.Max(1f, state.Restless / RestlessSeconds);
        state.Calm = speed <= calm * restless * restless ? state.Calm + Substep : 0f;
        state.IsAsleep = state.Calm > CalmSeconds;
        if (state.IsAsleep)
        {
            state.Speed = 0f;
            state.Debt = 0f;
            state.Velocities.AsSpan().Clear();
            state.Spins.AsSpan().Clear();
        }

        return state.IsAsleep;
    }

    private static void Locate(in RagdollPart part, in RootPlace root, in Pose model, out Vector3 centre, out Quaternion rotation)
    {
        Quaternion own = model.Rotations[part.Joint];
        centre = root.ToWorld(model.Positions[part.Joint] + Rotation.Rotate(own, part.Centre));
        rotation = Rotation.Multiply(root.Rotation, own);
    }

    /// <summary>Where a part's joint is on its parent, slid out of its place there; model space.</summary>
    private static Vector3 Place(ReadOnlySpan<RagdollPart> parts, int i, Vector3 slide, in Pose model)
    {
        ref readonly RagdollPart parent = ref parts[parts[i].Parent];
        return model.Positions[parent.Joint] + Rotation.Rotate(model.Rotations[parent.Joint], parent.Centre + parts[i].PivotInParent + slide);
    }

    private static Vector3 Spin(Quaternion now, Quaternion before)
    {
        Quaternion turn = Rotation.Multiply(now, Rotation.Inverse(before));
        return new Vector3(turn.X, turn.Y, turn.Z) * (turn.W < 0f ? -2f : 2f);
    }

    private static void Require(RagdollRig rig, RagdollState state, in Pose model)
    {
        RequireSame(rig, state);
        model.Require(rig.Skeleton);
    }

    private static void RequireSame(RagdollRig rig, RagdollState state)
    {
        if (!ReferenceEquals(rig, state.Rig))
        {
            throw new ArgumentException("the state was made for another rig; expected new RagdollState(rig)", nameof(state));
        }
    }
}
