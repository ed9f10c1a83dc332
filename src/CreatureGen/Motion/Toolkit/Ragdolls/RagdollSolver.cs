using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Ragdolls;

/// <summary>One substep of a ragdoll: move freely, bring everything back to where joints, limits and ground allow it, and read the velocities off what was moved.</summary>
/// <remarks>
/// Based on: M. Müller, M. Macklin, N. Chentanez, S. Jeschke and T.-Y. Kim, "Detailed rigid body simulation with extended position based dynamics" (2020), with zero compliance; the limits as one correction
/// of the relative rotation to the nearest rotation of <see cref="SwingTwistLimit"/>.
/// </remarks>
internal static class RagdollSolver
{
    // Radians and shares of the size per substep; faster parts would pass through their joints' other side.
    private const float MaxTurn = 0.5f;
    private const float MaxShift = 0.5f;

    // Muscles reach the speed they want so many times faster than they reach their pose, so that they do not swing through.
    private const float FirmnessPerTone = 4f;

    // Falls of a creature's own size, in whose speed it comes out of ground that it is found in: flung out at once it would fly as high as it was deep, many times over.
    private const float EmergenceFraction = 0.3f;

    /// <summary>Advances by a substep.</summary>
    public static void Advance<TGround>(RagdollState state, in RagdollSettings settings, float h, int rounds, TGround ground)
        where TGround : IGround
    {
        ReadOnlySpan<RagdollPart> parts = state.Rig.Parts;
        float air = Damping.Left(settings.AirDamping, h);
        Vector3 up = Vec.Normalize(-settings.Gravity, Vector3.UnitY);
        float size = state.Rig.Size * state.Scale;
        float maxShift = MaxShift * size;
        float emergence = EmergenceFraction * (float)Math.Sqrt(size * Vec.Length(settings.Gravity)) * h;
        for (int i = 0; i < parts.Length; i++)
        {
            Vector3 v = (state.Velocities[i] + (settings.Gravity * h)) * air;
            Vector3 w = state.Spins[i] * air;
            state.PastPositions[i] = state.Positions[i];
            state.PastRotations[i] = state.Rotations[i];
            state.Positions[i] += Shortened(v * h, maxShift);
            state.Rotations[i] = Turned(state.Rotations[i], Shortened(w * h, MaxTurn));
        }

        for (int round = 0; round < rounds; round++)
        {
            for (int i = 1; i < parts.Length; i++)
            {
                Angle(state, parts, i);
            }

            for (int i = 1; i < parts.Length; i++)
            {
                Attach(state, parts, i);
            }

            if (round == 0)
            {
                RagdollCollision.Separate(state, emergence);
            }

            Touch(state, settings.Friction, emergence, up, ground);
            for (int i = parts.Length - 1; i > 0; i--)
            {
                Attach(state, parts, i);
            }
        }

        float perSecond = 1f / h;
        for (int i = 0; i < parts.Length; i++)
        {
            state.Velocities[i] = (state.Positions[i] - state.PastPositions[i]) * perSecond;
            Quaternion turn = Rotation.Multiply(state.Rotations[i], Rotation.Inverse(state.PastRotations[i]));
            state.Spins[i] = new Vector3(turn.X, turn.Y, turn.Z) * (2f * perSecond * (turn.W < 0f ? -1f : 1f));
        }

        Rub(state, parts, settings, h);
    }

    /// <summary>Changes velocity and spin of a part as an impulse would that changes the velocity at a point by so much.</summary>
    public static void Push(RagdollState state, int part, Vector3 velocity, Vector3 point)
    {
        Vector3 arm = point - state.Positions[part];
        float speed = Vec.Length(velocity);
        if (!(speed > 0f))
        {
            return;
        }

        Vector3 direction = velocity / speed;
        ref readonly RagdollPart own = ref state.Rig.Parts[part];
        float weight = Weight(own, state.Rotations[part], arm, direction, state.Scale);
        Vector3 impulse = velocity / weight;
        state.Velocities[part] += impulse * own.InverseMass;
        state.Spins[part] += Spun(own, state.Rotations[part], Vec.Cross(arm, impulse), state.Scale);
    }

    /// <summary>Brings the relative rotation of a part within its limit.</summary>
    private static void Angle(RagdollState state, ReadOnlySpan<RagdollPart> parts, int i)
    {
        ref readonly RagdollPart child = ref parts[i];
        Quaternion carrier = Rotation.Multiply(state.Rotations[child.Parent], child.RestInParent);
        Quaternion turn = Rotation.Multiply(Rotation.Inverse(carrier), state.Rotations[i]);
        Quaternion wanted = Bounded(turn, child.Limit, state.Excesses[i]);
        if (wanted == turn)
        {
            return;
        }

        Quaternion correction = Rotation.Multiply(Rotation.Multiply(carrier, wanted), Rotation.Inverse(state.Rotations[i]));
        Vector3 axis = new Vector3(correction.X, correction.Y, correction.Z) * (correction.W < 0f ? -1f : 1f);
        float sine = Vec.Length(axis);
        if (!(sine > 1e-7f))
        {
            return;
        }

        axis /= sine;
        float angle = (float)(2 * PortableMath.Atan2(sine, Math.Abs(correction.W)));
        ref readonly RagdollPart parent = ref parts[child.Parent];
        float own = Vec.Dot(axis, Spun(child, state.Rotations[i], axis, 1f));
        float other = Vec.Dot(axis, Spun(parent, state.Rotations[child.Parent], axis, 1f));
        float scale = angle / (own + other);
        TurnBy(state, i, axis, own * scale);
        TurnBy(state, child.Parent, axis, -other * scale);
    }

    /// <summary>A turn brought to within an angle of its limit.</summary>
    public static Quaternion Bounded(Quaternion turn, JointLimit limit, float allowance)
    {
        Quaternion bounded = SwingTwistLimit.Clamp(turn, limit);
        if (allowance <= 0f || bounded == turn)
        {
            return bounded;
        }

        double excess = Rotation.AngleBetween(turn, bounded);
        return excess <= allowance ? turn : Rotation.Slerp(bounded, turn, allowance / excess);
    }

    private static void TurnBy(RagdollState state, int part, Vector3 axis, float angle) =>
        state.Rotations[part] = Rotation.Normalize(Rotation.Multiply(Rotation.FromAxisAngle(axis, angle), state.Rotations[part]));

    /// <summary>Brings a part and its parent together at their joint.</summary>
    private static void Attach(RagdollState state, ReadOnlySpan<RagdollPart> parts, int i)
    {
        ref readonly RagdollPart child = ref parts[i];
        int p = child.Parent;
        ref readonly RagdollPart parent = ref parts[p];
        Vector3 armChild = Rotation.Rotate(state.Rotations[i], child.Centre) * -state.Scale;
        Vector3 armParent = Rotation.Rotate(state.Rotations[p], child.PivotInParent + state.Slides[i]) * state.Scale;
        Vector3 gap = state.Positions[p] + armParent - (state.Positions[i] + armChild);
        float distance = Vec.Length(gap);
        if (!(distance > 1e-9f))
        {
            return;
        }

        Vector3 direction = gap / distance;
        float own = Weight(child, state.Rotations[i], armChild, direction, state.Scale);
        float other = Weight(parent, state.Rotations[p], armParent, direction, state.Scale);
        Vector3 push = gap / (own + other);
        Move(state, child, i, armChild, push);
        Move(state, parent, p, armParent, -push);
    }

    /// <summary>Keeps all balls from going into the ground, brings those that are in it out by no more than so many metres, and holds them back along it.</summary>
    private static void Touch<TGround>(RagdollState state, float friction, float emergence, Vector3 up, TGround ground)
        where TGround : IGround
    {
        ReadOnlySpan<RagdollContact> contacts = state.Rig.Contacts;
        ReadOnlySpan<RagdollPart> parts = state.Rig.Parts;
        float size = state.Rig.Size * state.Scale;
        for (int c = 0; c < contacts.Length; c++)
        {
            ref readonly RagdollContact contact = ref contacts[c];
            int i = contact.Part;
            ref readonly RagdollPart part = ref parts[i];
            float radius = contact.Radius * state.Scale;
            Vector3 centre = Rotation.Rotate(state.Rotations[i], contact.Place) * state.Scale;
            if (!RagdollFloor.TryFind(ground, state.Anchor + state.Positions[i] + centre, radius, size, up, out GroundHit hit))
            {
                continue;
            }

            Vector3 normal = hit.Normal;
            float depth = radius - (state.Allowances[c] * state.Scale) - Vec.Dot(state.Positions[i] + centre - (hit.Point - state.Anchor), normal);
            if (!(depth > 0f))
            {
                continue;
            }

            // How far the touching point went into the ground and along it in this substep; friction takes the second back, at most its share of the push.
            Vector3 arm = centre - (normal * radius);
            Vector3 past = state.PastPositions[i] + Rotation.Rotate(Rotation.Multiply(state.PastRotations[i], Rotation.Inverse(state.Rotations[i])), arm);
            depth = Math.Min(depth, Vec.Dot(past - (state.Positions[i] + arm), normal) + emergence);
            if (!(depth > 0f))
            {
                continue;
            }

            Move(state, part, i, arm, normal * (depth / Weight(part, state.Rotations[i], arm, normal, state.Scale)));
            Vector3 slip = Vec.Reject(state.Positions[i] + arm - past, normal);
            float slid = Vec.Length(slip);
            if (slid > 1e-9f)
            {
                Vector3 direction = slip / slid;
                float back = Math.Min(slid, friction * depth);
                Move(state, part, i, arm, direction * (-back / Weight(part, state.Rotations[i], arm, direction, state.Scale)));
            }
        }
    }

    /// <summary>Brings the turning of neighbouring parts against each other some way to that which muscles want: none at all, or towards their pose.</summary>
    private static void Rub(RagdollState state, ReadOnlySpan<RagdollPart> parts, in RagdollSettings settings, float h)
    {
        float known = -1f;
        float fraction = 0f;
        for (int i = 1; i < parts.Length; i++)
        {
            float tone = settings.Tone + state.Tones[i];
            if (tone != known)
            {
                known = tone;
                fraction = 1f - Damping.Left(settings.JointDamping + (FirmnessPerTone * tone), h);
            }

            if (fraction <= 0f)
            {
                continue;
            }

            ref readonly RagdollPart child = ref parts[i];
            Vector3 against = state.Spins[i] - state.Spins[child.Parent];
            if (tone > 0f)
            {
                Quaternion carrier = Rotation.Multiply(state.Rotations[child.Parent], child.RestInParent);
                Quaternion left = Rotation.Multiply(Rotation.Multiply(carrier, state.Targets[i]), Rotation.Inverse(state.Rotations[i]));
                against -= new Vector3(left.X, left.Y, left.Z) * (left.W < 0f ? -2f * tone : 2f * tone);
            }

            float own = Sum(child.InverseInertia);
            float other = Sum(parts[child.Parent].InverseInertia);
            state.Spins[i] -= against * (fraction * own / (own + other));
            state.Spins[child.Parent] += against * (fraction * other / (own + other));
        }
    }

    private static float Sum(Vector3 v) => v.X + v.Y + v.Z;

    /// <summary>Moves and turns a part as an impulse at a point would.</summary>
    internal static void Move(RagdollState state, in RagdollPart part, int i, Vector3 arm, Vector3 push)
    {
        state.Positions[i] += push * part.InverseMass;
        state.Rotations[i] = Turned(state.Rotations[i], Spun(part, state.Rotations[i], Vec.Cross(arm, push), state.Scale));
    }

    /// <summary>Generalised inverse mass of a part at a point, along a direction.</summary>
    internal static float Weight(in RagdollPart part, Quaternion rotation, Vector3 arm, Vector3 direction, float scale)
    {
        Vector3 moment = Vec.Cross(arm, direction);
        return part.InverseMass + Vec.Dot(moment, Spun(part, rotation, moment, scale));
    }

    /// <summary>Inverse inertia times a moment, world axes.</summary>
    private static Vector3 Spun(in RagdollPart part, Quaternion rotation, Vector3 moment, float scale)
    {
        Vector3 own = Rotation.Rotate(Rotation.Inverse(rotation), moment) * part.InverseInertia / (scale * scale);
        return Rotation.Rotate(rotation, own);
    }

    private static Quaternion Turned(Quaternion rotation, Vector3 turn)
    {
        float angle = Vec.Length(turn);
        return angle > 1e-9f ? Rotation.Normalize(Rotation.Multiply(Rotation.FromAxisAngle(turn / angle, angle), rotation)) : rotation;
    }

    private static Vector3 Shortened(Vector3 v, float max)
    {
        float length = Vec.Length(v);
        return length > max ? v * (max / length) : v;
    }
}
