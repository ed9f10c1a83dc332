using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Springs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Something that spring bones stay out of: a sphere or capsule that a joint carries or that stands in the world, or a plane with everything behind it.</summary>
public readonly struct SpringCollider
{
    // Pushing a bone out and bringing its bone back to length undo a part of each other; a few rounds settle it.
    private const int Rounds = 4;

    private SpringCollider(SpringColliderKind kind, int joint, Vector3 start, Vector3 end, float radius)
    {
        Kind = kind;
        Joint = joint;
        Start = start;
        End = end;
        Radius = radius;
    }

    /// <summary>What shape it has.</summary>
    internal SpringColliderKind Kind { get; }

    /// <summary>The joint that carries it, −1 for the world.</summary>
    internal int Joint { get; }

    /// <summary>First centre, or a point of the plane.</summary>
    internal Vector3 Start { get; }

    /// <summary>Second centre, or the unit normal of the plane.</summary>
    internal Vector3 End { get; }

    /// <summary>Metres.</summary>
    internal float Radius { get; }

    /// <summary>A capsule that a joint carries.</summary>
    /// <param name="capsule">In the joint's space, model metres.</param>
    /// <exception cref="System.ArgumentException">A number is not finite.</exception>
    public static SpringCollider Of(CapsuleCollider capsule) => Capsule(capsule.Joint, capsule.Start, capsule.End, capsule.Radius);

    /// <summary>A capsule; a sphere if both centres are the same.</summary>
    /// <param name="joint">The joint that carries it, −1 for the world.</param>
    /// <param name="start">Centre of the first half sphere; joint space in model metres, or world space in world metres.</param>
    /// <param name="end">Centre of the second half sphere, likewise.</param>
    /// <param name="radius">Likewise, not negative.</param>
    /// <exception cref="System.ArgumentException">A number is not finite.</exception>
    public static SpringCollider Capsule(int joint, Vector3 start, Vector3 end, float radius)
    {
        Finite.Require(start, nameof(start));
        Finite.Require(end, nameof(end));
        Finite.RequireWithin(radius, 0f, float.MaxValue, nameof(radius));
        return new SpringCollider(SpringColliderKind.Capsule, joint, start, end, radius);
    }

    /// <summary>A plane in the world; bones stay on the side that its normal points to.</summary>
    /// <param name="point">On the plane, world space, metres.</param>
    /// <param name="normal">World space, any length but none.</param>
    /// <exception cref="System.ArgumentException">A number is not finite.</exception>
    public static SpringCollider Plane(Vector3 point, Vector3 normal)
    {
        Finite.Require(point, nameof(point));
        Finite.Require(normal, nameof(normal));
        return new SpringCollider(SpringColliderKind.Plane, -1, point, Vec.Normalize(normal, Vector3.UnitY), 0f);
    }

    /// <summary>Whether a bone's tip is certainly out of the collider as it is: told of planes only.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal bool Clears(Vector3 place, Vector3 bone, float radius) => Kind == SpringColliderKind.Plane && Vec.Dot((place - Start) + bone, End) >= radius;

    /// <summary>A bone turned about its joint until all of it, a capsule of a radius, is out of the collider, as far as a bone of its length can be; all in one space.</summary>
    /// <param name="place">Of the joint.</param>
    /// <param name="bone">From the joint to the tip.</param>
    /// <param name="length">Of the bone.</param>
    /// <param name="radius">Of the bone.</param>
    internal Vector3 Turn(Vector3 place, Vector3 bone, float length, float radius)
    {
        if (Kind == SpringColliderKind.Plane)
        {
            float rise = Vec.Dot(bone, End);
            float min = System.Math.Min(radius - Vec.Dot(place - Start, End), length);
            if (rise >= min)
            {
                return bone;
            }

            Vector3 along = Vec.Normalize(Vec.Reject(bone, End), Vec.Perpendicular(End));
            return (End * min) + (along * (float)System.Math.Sqrt(System.Math.Max(0f, (length * length) - (min * min))));
        }

        // A joint that lies in the collider holds its end of the bone in it: the bone's side keeps the distance that the joint has, its tip the whole.
        float full = Radius + radius;
        float side = System.Math.Min(full, Vec.Distance(place, NearestTo(place)));
        for (int round = 0; round < Rounds; round++)
        {
            Vector3 pushed = PushSide(place, bone, side);
            pushed = pushed == bone ? bone : Vec.Normalize(pushed, bone / length) * length;
            Vector3 tip = place + pushed;
            Vector3 nearest = NearestTo(tip);
            Vector3 away = tip - nearest;
            if (Vec.LengthSquared(away) < full * full)
            {
                Vector3 lifted = nearest + (Vec.Normalize(away, Vec.Perpendicular(End - Start)) * full) - place;
                pushed = Vec.Normalize(lifted, pushed / length) * length;
            }

            if (pushed == bone)
            {
                break;
            }

            bone = pushed;
        }

        return bone;
    }

    /// <summary>The point of the axis nearest to another.</summary>
    private Vector3 NearestTo(Vector3 point)
    {
        Vector3 axis = End - Start;
        float squared = Vec.LengthSquared(axis);
        float t = squared > 0f ? Scalar.Clamp(Vec.Dot(point - Start, axis) / squared, 0f, 1f) : 0f;
        return Start + (axis * t);
    }

    /// <summary>A vector along which a bone lies no nearer to the axis than a distance, to first order; the bone itself where it does.</summary>
    private Vector3 PushSide(Vector3 place, Vector3 bone, float min)
    {
        float part = Segments.Nearest(place, bone, Start, End - Start, out float along);
        Vector3 nearest = Start + ((End - Start) * along);
        Vector3 away = place + (bone * part) - nearest;
        float distance = Vec.Length(away);
        if (distance >= min || part <= 0f)
        {
            return bone;
        }

        Vector3 across = Vec.Cross(bone, End - Start);
        Vector3 direction = Vec.Normalize(away, Vec.Normalize(across, Vec.Perpendicular(bone)));
        return (bone * part) + (direction * (min - distance));
    }

    /// <summary>The same with its points where they are in another space.</summary>
    internal SpringCollider Moved(Vector3 start, Vector3 end, float radius) => new(Kind, Joint, start, end, radius);
}
