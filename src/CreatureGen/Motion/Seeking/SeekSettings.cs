using System;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <summary>How a creature goes to a target and keeps its distance.</summary>
public readonly struct SeekSettings
{
    /// <summary>Part of its cruise at which a swimmer or flier climbs.</summary>
    private const float ClimbPart = 0.35f;

    /// <summary>Sets the manners.</summary>
    /// <param name="speed">Metres per second ahead, not negative.</param>
    /// <param name="turnSpeed">Radians per second, not negative.</param>
    /// <param name="near">Metres; a target nearer than this is backed away from.</param>
    /// <param name="far">Metres; a target farther than this is approached; above <paramref name="near"/>.</param>
    /// <param name="turnBeyond">Radians off ahead at which turning begins.</param>
    /// <param name="facing">Radians off ahead at which turning ends; below <paramref name="turnBeyond"/>.</param>
    /// <param name="moveWithin">Radians off ahead within which it walks; beyond, it turns on the spot first.</param>
    /// <param name="retreatFraction">Speed backwards, share of that ahead.</param>
    /// <param name="climbSpeed">Metres per second up and down, not negative; 0 for what stays on the ground, which goes to where its target is seen from above.</param>
    /// <param name="easing">s⁻¹, above 0: the speed wanted is at most so many times what is left of the way. The slower a body brakes, the less.</param>
    /// <exception cref="ArgumentException">A number is outside its range or not a number.</exception>
    public SeekSettings(float speed, float turnSpeed = 1.745f, float near = 4.5f, float far = 6f, float turnBeyond = 0.35f, float facing = 0.05f, float moveWithin = 1.5708f, float retreatFraction = 0.66f, float climbSpeed = 0f, float easing = 3f)
    {
        Finite.RequireWithin(climbSpeed, 0f, 1e6f, nameof(climbSpeed));
        Finite.RequireWithin(easing, 1e-3f, 1e3f, nameof(easing));
        ClimbSpeed = climbSpeed;
        Easing = easing;
        Finite.RequireWithin(speed, 0f, 1e6f, nameof(speed));
        Finite.RequireWithin(turnSpeed, 0f, 1e3f, nameof(turnSpeed));
        Finite.RequireWithin(near, 0f, 1e6f, nameof(near));
        Finite.RequireWithin(far, near, 1e6f, nameof(far));
        Finite.RequireWithin(turnBeyond, 1e-4f, 3.1416f, nameof(turnBeyond));
        Finite.RequireWithin(facing, 0f, turnBeyond, nameof(facing));
        Finite.RequireWithin(moveWithin, 1e-3f, 3.1416f, nameof(moveWithin));
        Finite.RequireWithin(retreatFraction, 0f, 1f, nameof(retreatFraction));
        Speed = speed;
        TurnSpeed = turnSpeed;
        Near = near;
        Far = far;
        TurnBeyond = turnBeyond;
        Facing = facing;
        MoveWithin = moveWithin;
        RetreatFraction = retreatFraction;
    }

    /// <summary>Of a game's own figure: 2 m/s, 100°/s, between 4.5 and 6 m. <see cref="For"/> knows a creature.</summary>
    public static SeekSettings Default { get; } = new(2f);

    /// <summary>Metres per second ahead.</summary>
    public float Speed { get; }

    /// <summary>Radians per second.</summary>
    public float TurnSpeed { get; }

    /// <summary>Metres.</summary>
    public float Near { get; }

    /// <summary>Metres.</summary>
    public float Far { get; }

    /// <summary>Radians.</summary>
    public float TurnBeyond { get; }

    /// <summary>Radians.</summary>
    public float Facing { get; }

    /// <summary>Radians.</summary>
    public float MoveWithin { get; }

    /// <summary>Share of the speed.</summary>
    public float RetreatFraction { get; }

    /// <summary>Metres per second up and down.</summary>
    public float ClimbSpeed { get; }

    /// <summary>s⁻¹.</summary>
    public float Easing { get; }

    /// <summary>The manners of a creature: at its own pace, turning as its size allows, it comes until its nose is at the target, and backs away from what is under it. Swimmers and fliers in the air seek in space.</summary>
    /// <param name="profile">The creature.</param>
    /// <param name="medium">Where it is to seek; of effect for fliers with legs.</param>
    /// <param name="scale">World metres for a metre of the model.</param>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    /// <exception cref="ArgumentException">The scale is not above 0 or not a number.</exception>
    public static SeekSettings For(MotionProfile profile, MotionMedium medium = MotionMedium.Ground, float scale = 1f)
    {
        _ = profile ?? throw new ArgumentNullException(nameof(profile));
        Finite.RequireWithin(scale, 1e-4f, 1e4f, nameof(scale));
        float front = 0f;
        float rear = 0f;
        foreach (Joint joint in profile.Subject.Skeleton.Joints)
        {
            front = Math.Max(front, joint.ModelPosition.Z);
            rear = Math.Min(rear, joint.ModelPosition.Z);
        }

        float size = Math.Max(front - rear, 1e-3f) * scale;
        bool swims = profile.Swim != null;
        bool flies = profile.Flight != null && (medium == MotionMedium.Air || profile.Legs == null);
        float pace = profile.Swim?.CruiseSpeed ?? (flies ? profile.Flight!.CruiseSpeed : profile.Gaits?.Speeds[0].Comfortable ?? profile.Slither?.CruiseSpeed ?? 0f);

        // What is so many times longer takes the root of it as much time to turn and to stop.
        float tempo = MathF.Sqrt(1f / size);
        return new SeekSettings(
            pace * scale,
            Scalar.Clamp(1.5f * tempo, 0.5f, 3f),
            (front * scale) + (0.05f * size),
            (front * scale) + (0.4f * size),
            climbSpeed: swims || flies ? ClimbPart * pace * scale : 0f,
            easing: Scalar.Clamp(2f * tempo, 0.4f, 4f));
    }

    /// <summary>The same that goes to its target itself, and stops on it, instead of keeping a distance.</summary>
    /// <param name="tolerance">Metres of the target within which it has arrived, above 0.</param>
    /// <exception cref="ArgumentException">It is not above 0 or not a number.</exception>
    public SeekSettings Arriving(float tolerance)
    {
        Finite.RequireWithin(tolerance, 1e-6f, 1e6f, nameof(tolerance));
        return new SeekSettings(Speed, TurnSpeed, 0f, tolerance, TurnBeyond, Facing, MoveWithin, RetreatFraction, ClimbSpeed, Easing);
    }
}
