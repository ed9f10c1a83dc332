using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>A body that nothing holds up: a ragdoll that takes over pose and velocities, and the place that goes along with it.</summary>
internal sealed class LimpBody
{
    /// <summary>What of its weight water does not carry, and how much it slows, per second.</summary>
    private const float SunkWeight = 0.03f;
    private const float WaterDamping = 2.5f;

    /// <summary>How quickly the body is lifted out of the ground by its skin, per second.</summary>
    private const float LiftRate = 12f;

    /// <summary>Least time that it lies, τ = √(ℓ/g), and speed below which it can begin to get up, √(gℓ).</summary>
    private const float FallTime = 3f;
    private const float CalmSpeed = 0.12f;

    /// <summary>How long who was knocked down lies before it gets up by itself, τ: it has not come to lie on its side before.</summary>
    private const float DazedTime = 6.5f;

    /// <summary>How much of that is added for each such time that it has lain beyond the first, and up to how much in all: on stairs a body slips from edge to edge for long, and catches itself while it does.</summary>
    private const float Patience = 1f;
    private const float MostPatience = 2.5f;

    /// <summary>Where a cast for the ground begins above the body, and how high above the ground that the root is on it, and that it is not at all, sizes.</summary>
    private const float CastAbove = 0.5f;
    private const float NearAbove = 1f;
    private const float FarAbove = 2.5f;

    /// <summary>How far beside its middle a body still has ground under it, sizes.</summary>
    private const float Beside = 0.15f;

    private readonly FallProfile profile;
    private readonly RagdollState ragdoll;
    private readonly PoseBuffer before;
    private readonly PoseBuffer now;
    private Topple topple;
    private float seconds;
    private float lift;

    public LimpBody(FallProfile profile)
    {
        this.profile = profile;
        ragdoll = new RagdollState(profile.Ragdoll);
        before = new PoseBuffer(profile.Skeleton);
        now = new PoseBuffer(profile.Skeleton);
    }

    /// <summary>Whether time has passed since it went limp.</summary>
    public bool Falls => seconds > 0f;

    /// <summary>Whether it has fallen, and lies still enough to get up.</summary>
    /// <param name="scale">World metres per model metre.</param>
    /// <param name="gravity">World m/s².</param>
    /// <param name="dazed">Whether it was knocked down, and nobody has it get up or go.</param>
    public bool IsCalm(float scale, float gravity, bool dazed)
    {
        float tau = Tau(scale, gravity);
        float times = seconds / (FallTime * tau);
        return (!dazed || seconds > DazedTime * tau)
            && (ragdoll.IsAsleep || (times > 1f && ragdoll.Speed < CalmSpeed * Math.Min(1f + (Patience * (times - 1f)), MostPatience) * gravity * tau));
    }

    /// <summary>Keeps the pose shown last: its velocities are those from this pose to the one in which it begins.</summary>
    public void Keep(in Pose shown) => before.Take(shown);

    /// <summary>Goes limp. What gaze, acts and springs turn is as it was shown last, and goes along with what carries it: the pose of this moment is without them, and to take the difference for a velocity would throw the body over its head.</summary>
    /// <param name="place">Where the root is.</param>
    /// <param name="shown">The pose of this moment, in the parents' space; receives that in which it begins.</param>
    /// <param name="placeBefore">Where the root was when the pose was kept.</param>
    /// <param name="dt">Seconds since then.</param>
    /// <param name="ground">What it falls on.</param>
    public void Begin(in RootPlace place, in Pose shown, in RootPlace placeBefore, float dt, IGround ground)
    {
        foreach (int joint in profile.Overlaid)
        {
            shown.Rotations[joint] = before.Local.Rotations[joint];
        }

        now.Take(shown);
        now.Finish();
        before.Finish();
        Ragdoll.Start(profile.Ragdoll, ragdoll, place, now.Model, placeBefore, before.Model, dt, ground);
        Ragdoll.Aim(profile.Ragdoll, ragdoll, now.Model);
        profile.Tone.Relax(ragdoll.Targets);
        before.Take(shown);
        Vector3 velocity = dt > 0f ? (place.Position - placeBefore.Position) / dt : Vector3.Zero;
        topple.Begin(Rotation.Rotate(place.Rotation, Vector3.UnitX), Rotation.Rotate(place.Rotation, Vector3.UnitZ), profile.Topple, velocity, (float)Math.Sqrt(StandardGravity.Acceleration * profile.Height * place.Scale));
        seconds = 0f;
        lift = 0f;
    }

    /// <summary>Leaves the pose as it was shown last: what an act did with trunk and limbs, which rolls over whole bodies and moves those that no feet carry, ends with it and is no velocity.</summary>
    /// <param name="shown">The pose of this moment, in the parents' space.</param>
    public void Hold(in Pose shown)
    {
        before.Local.Rotations.CopyTo(shown.Rotations);
        before.Local.Positions.CopyTo(shown.Positions);
    }

    /// <summary>Pushes a part.</summary>
    /// <param name="joint">A joint of it.</param>
    /// <param name="impulse">World N·s.</param>
    /// <param name="scale">World metres per model metre.</param>
    /// <param name="gravity">World m/s²: nothing is thrown faster than a fall from twice its height.</param>
    public void Push(int joint, Vector3 impulse, float scale, float gravity)
    {
        Vector3 change = impulse / (profile.Mass * scale * scale * scale * profile.Ragdoll.MassOf(joint));
        float max = 2f * (float)Math.Sqrt(gravity * profile.Height * scale);
        float length = Vec.Length(change);
        if (!Falls)
        {
            topple.Push(impulse);
        }

        ragdoll.Push(joint, length > max ? change * (max / length) : change, ragdoll.CentreOf(joint));
    }

    /// <summary>Falls on, or lies.</summary>
    /// <returns>Where the root is then: under the body, facing as it did.</returns>
    public RootPlace Advance(in RootPlace place, float dt, in MotionSettings settings, IGround ground)
    {
        seconds += dt;
        bool swims = profile.Swims;
        float weight = swims ? SunkWeight : 1f;
        float tau = Tau(place.Scale, settings.Gravity);
        profile.Tone.Write(seconds, tau, ragdoll.Tones);
        var material = new RagdollSettings(settings.Up * (-weight * settings.Gravity), airDamping: swims ? WaterDamping : 0.5f);
        topple.Turn(ragdoll, dt, seconds, tau, settings.Up);
        Ragdoll.Advance(profile.Ragdoll, ragdoll, material, ground, dt);
        return PlaceOf(place.Rotation, place.Scale, settings.Up, ground);
    }

    /// <summary>Writes the pose.</summary>
    /// <param name="place">Where the root is.</param>
    /// <param name="dt">Seconds since the last.</param>
    /// <param name="settings">Up.</param>
    /// <param name="ground">What it lies on.</param>
    /// <param name="local">Receives it; joints that are no parts are as they were when it went limp.</param>
    public void Show(in RootPlace place, float dt, in MotionSettings settings, IGround ground, in Pose local)
    {
        now.Take(before.Local);
        now.Finish();
        Ragdoll.Show(profile.Ragdoll, ragdoll, place, now.Local, now.Model);

        // Skin stands out of the capsules that lie on the ground: toes give way to it, what head and tail wear bends them up, all else lifts the body.
        foreach (LyingLeg leg in profile.Legs)
        {
            GroundClearance.BendFoot(profile, leg, now, place, settings.Up, ground);
        }

        float body = Math.Max(0f, -profile.Support.Lowest(BodyPart.Trunk | BodyPart.Limb, place, now.Model, settings.Up, ground, out _));
        profile.Raise(now.Local, body);
        now.Finish();
        GroundClearance.BendUp(profile, now, place, settings.Up, ground);
        float wanted = body + Math.Max(0f, -profile.Support.Lowest(place, now.Model, settings.Up, ground));
        lift = Damping.Approach(lift, wanted, LiftRate, dt);
        now.Local.Rotations.CopyTo(local.Rotations);
        now.Local.Positions.CopyTo(local.Positions);
        profile.Raise(local, Math.Max(lift, wanted) - body);
    }

    /// <summary>Where it gets up: under its body, facing as that does.</summary>
    public RootPlace PlaceUnder(in RootPlace place, in MotionSettings settings, IGround ground) =>
        PlaceOf(Facing(place, settings.Up), place.Scale, settings.Up, ground);

    /// <summary>Ends it.</summary>
    public void Stop() => ragdoll.Stop();

    /// <summary>Moves the origin of the world.</summary>
    public void Rebase(Vector3 offset) => ragdoll.Rebase(offset);

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(LimpBody other)
    {
        ragdoll.CopyFrom(other.ragdoll);
        before.Take(other.before.Local);
        (topple, seconds, lift) = (other.topple, other.seconds, other.lift);
    }

    private float Tau(float scale, float gravity) => (float)Math.Sqrt(profile.Height * scale / gravity);

    /// <summary>The heading of the body.</summary>
    private Quaternion Facing(in RootPlace place, Vector3 up)
    {
        Quaternion turned = ragdoll.FirstTurn;
        Vector3 ahead = Rotation.Rotate(turned, Vector3.UnitZ);
        Vector3 level = Vec.Reject(ahead, up);

        // Standing on its nose or tail it faces where its back or belly does.
        if (Vec.LengthSquared(level) < 0.02f)
        {
            level = Vec.Reject(Rotation.Rotate(turned, Vector3.UnitY), up) * (Vec.Dot(ahead, up) > 0f ? -1f : 1f);
        }

        Vector3 own = Rotation.Rotate(place.Rotation, Vector3.UnitY);
        Quaternion upright = Rotation.Multiply(Rotation.FromTo(own, up), place.Rotation);
        Vector3 before = Rotation.Rotate(upright, Vector3.UnitZ);
        level = Vec.Normalize(level, before);
        double angle = PortableMath.Atan2(Vec.Dot(Vec.Cross(before, level), up), Vec.Dot(before, level));
        return Rotation.Normalize(Rotation.Multiply(Rotation.FromAxisAngle(up, angle), upright));
    }

    private RootPlace PlaceOf(Quaternion rotation, float scale, Vector3 up, IGround ground)
    {
        Vector3 joint = ragdoll.FirstPlace;
        Vector3 rest = Rotation.Rotate(rotation, profile.Skeleton.ModelPositions[profile.Ragdoll.FirstJoint]) * scale;
        Vector3 under = joint - rest;
        float size = profile.Ragdoll.Size * scale;
        if (Find(joint, rotation, up, size, ground, out GroundHit hit))
        {
            // On the ground, to which it comes as the body does from high above; of what swims no lower.
            float lift = Vec.Dot(hit.Point - under, up);
            float near = Scalar.Smooth((FarAbove - (Vec.Dot(joint - hit.Point, up) / size)) / (FarAbove - NearAbove));
            under += up * (profile.Swims ? Math.Max(lift, 0f) : lift * near);
        }

        return new RootPlace(under, rotation, scale);
    }

    /// <summary>The ground under a body, or beside its middle where that lies over a slit: what lies across one gets up on its rims and not in it.</summary>
    private static bool Find(Vector3 middle, Quaternion facing, Vector3 up, float size, IGround ground, out GroundHit hit)
    {
        float above = CastAbove * size;
        Vector3 from = middle + (up * above);
        float distance = above + (FarAbove * size);
        Vector3 aside = Rotation.Rotate(facing, Vector3.UnitX) * (Beside * size);
        Vector3 ahead = Rotation.Rotate(facing, Vector3.UnitZ) * (Beside * size);
        return ground.Cast(from, -up, distance, out hit)
            || Below(from + aside, out hit)
            || Below(from - aside, out hit)
            || Below(from + ahead, out hit)
            || Below(from - ahead, out hit);

        // A body that falls past an edge has solid ground beside it, whose surface is above.
        bool Below(Vector3 origin, out GroundHit hit) => ground.Cast(origin, -up, distance, out hit) && Vec.Dot(origin - hit.Point, up) >= 0f;
    }
}
