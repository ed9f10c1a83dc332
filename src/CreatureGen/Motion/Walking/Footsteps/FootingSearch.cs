using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Steps;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>Finds ground for a foot: below where it wants to go, or nearby when there is a gap, an edge or a wall; and what stands in its way.</summary>
internal sealed partial class FootingSearch
{
    /// <summary>Where rays begin above the slope on which the body is, part of the leg's length: steps up to this height are taken.</summary>
    private const float Above = 0.8f;

    /// <summary>How far below that slope a foot finds footing, part of the leg's length.</summary>
    private const float Below = 0.9f;

    /// <summary>How much farther up and down it looks where there is nothing, part of the leg's length.</summary>
    private const float Farther = 1.5f;

    /// <summary>Least cosine of a slope that holds a foot (60°).</summary>
    private const float Steepest = 0.5f;

    /// <summary>Drop at toe or heel that counts as an edge, beyond what the ground's slope there or at the ball explains, part of the leg's length.</summary>
    private const float EdgeDrop = 0.12f;

    /// <summary>The same of a rise that counts as a wall.</summary>
    private const float WallRise = 0.06f;

    /// <summary>Part of the sole's extent at which the ground under its ends is felt: just beyond them, so that no tip is in a wall.</summary>
    private const float EndFraction = 1.05f;

    /// <summary>The same of its sides.</summary>
    private const float SideFraction = 0.95f;

    /// <summary>How far beyond its toes a foot rolls on over their tip, leg lengths: no wall is to be there.</summary>
    private const float RollsOn = 0.15f;

    /// <summary>How much the ground that a heel hangs above counts in the ground under a sole; the rest is under ball and toes.</summary>
    private const float HeelFraction = 0.29f;

    /// <summary>How far the ground under a heel is below the place at most, leg lengths.</summary>
    private const float MostBelow = 0.3f;

    /// <summary>Part of the leg's length from which on a sole is long or wide.</summary>
    private const float LongSole = 0.15f;

    /// <summary>Rise over its distance up to which a sole is laid on bent ground; from twice that on it is not.</summary>
    private const float BendOfGround = 0.4f;

    /// <summary>How high a heel is above bent ground on which the middle of its sole stands, leg lengths, where it is wholly in the air.</summary>
    private const float WhollyBent = 0.03f;

    /// <summary>What a swinging foot is lifted over at most, part of the leg's length.</summary>
    private const float Highest = 0.6f;

    /// <summary>Share of a change that is taken up when the ground along a way is felt again.</summary>
    private const float Renewal = 0.5f;

    /// <summary>Where else ground is looked for, leg lengths along the foot and toward the middle: the nearest first, along before aside, in before out.</summary>
    private static readonly (float Ahead, float In)[] alternatives =
    {
        (-0.2f, 0f), (0.2f, 0f), (0f, 0.2f), (0f, -0.2f), (-0.2f, 0.2f), (0.2f, 0.2f), (-0.2f, -0.2f), (0.2f, -0.2f), (-0.4f, 0f), (0.4f, 0f), (-0.4f, 0.2f), (0.4f, 0.2f), (-0.4f, -0.2f), (0.4f, -0.2f), (-0.6f, 0f),
    };

    /// <summary>How far away from where a foot wants to go it keeps to the ground that it has found, where there is nothing below; leg lengths.</summary>
    private const float KeepsTo = 0.45f;

    /// <summary>Where a sole of spread toes may stand on something, of the length of its toes and half its width.</summary>
    private static readonly (float Along, float Across)[] fan = { (1f, 0.52f), (1f, -0.52f), (0.75f, SideFraction), (0.75f, -SideFraction) };

    private readonly LeggedBody body;

    public FootingSearch(LeggedBody body) => this.body = body;

    /// <summary>Finds a place for a foot.</summary>
    /// <param name="step">The moment.</param>
    /// <param name="leg">Whose foot.</param>
    /// <param name="wanted">Under the ball, model space; its height does not count.</param>
    /// <param name="home">Where that is under the body in the middle of the stance, model space: feet turn with their legs.</param>
    /// <param name="yaw">Heading of the foot there, radians from the body's.</param>
    /// <param name="shift">Along the foot, metres: what keeps it off an edge.</param>
    /// <param name="before">The place to which it went before, world space: it keeps to that where there is nothing below; null where it has none yet.</param>
    /// <param name="place">The place; its heading is not set.</param>
    /// <returns>Whether there is ground.</returns>
    public bool Find(in StepContext step, int leg, Vector3 wanted, Vector3 home, float yaw, float shift, Vector3? before, out Foothold place)
    {
        LegRig shape = body.Legs[leg];
        Vector3 up = step.Up;
        Vector3 ahead = Ahead(yaw);
        Vector3 target = wanted + (ahead * shift);
        bool found = Down(step, target, out GroundHit hit);
        if (!found && before is Vector3 earlier)
        {
            Vector3 there = step.Frame.ToModel(earlier);
            if (Scalar.Square(there.X - wanted.X) + Scalar.Square(there.Z - wanted.Z) < Scalar.Square(KeepsTo * shape.Length))
            {
                target = there;
                found = Down(step, target, out hit);
            }
        }

        if (!found)
        {
            for (int i = 0; i < alternatives.Length && !found; i++)
            {
                Vector3 inward = new Vector3(ahead.Z, 0f, -ahead.X) * (shape.Home.X > 0f ? -1f : 1f);
                target = wanted + (((ahead * alternatives[i].Ahead) + (inward * alternatives[i].In)) * shape.Length);
                found = Down(step, target, out hit);
            }
        }

        if (!found)
        {
            // The body itself may be too deep or too high to see what its feet are above.
            target = wanted + (ahead * shift);
            found = Down(step, target, Farther, out hit);
        }

        if (!found)
        {
            place = new Foothold { Position = step.Frame.ToWorld(new Vector3(wanted.X, 0f, wanted.Z)), Normal = up };
            return false;
        }

        bool uneven = step.Ground is not IPlaneGround;
        Sole sole = default;
        if (uneven)
        {
            sole = LaidOut(shape, home, ahead);
            Feel(step, shape, target, hit, ref sole);
        }

        place = new Foothold { Position = hit.Point, Normal = hit.Normal, Surface = hit.Surface, Platform = hit.Platform };
        if (uneven)
        {
            place.Below = sole.Heel == SoleEnd.Hangs ? Math.Min(sole.Below - sole.Raise, 0f) : 0f;
            place.InWall = sole.Toes == SoleEnd.Wall || sole.Heel == SoleEnd.Wall;
            place.MeetsWall = sole.Toes == SoleEnd.Wall || sole.Before == SoleEnd.Wall;
            place.Overhangs = sole.Toes == SoleEnd.Hangs;
            place.Whole = place.MeetsWall || sole.Heel == SoleEnd.Hangs ? 1f : Scalar.Smooth(sole.UnderHeel / (WhollyBent * shape.Length));
            place.Position += up * (sole.Raise * step.Frame.Scale);
            Vector3 tilt = Rotation.Rotate(step.Frame.Rotation, (sole.Ahead * sole.Slope) + (sole.Aside * sole.Tilt));
            place.Normal = Vec.Normalize((place.Normal / Vec.Dot(place.Normal, up)) - tilt, up);
        }

        return true;
    }

    /// <summary>Where a heading points; most feet point straight ahead.</summary>
    private static Vector3 Ahead(float yaw)
    {
        if (yaw == 0f)
        {
            return Vector3.UnitZ;
        }

        PortableMath.SinCos(yaw, out double sine, out double cosine);
        return new Vector3((float)sine, 0f, (float)cosine);
    }

    /// <summary>Feels the ground along the way of a swing, all of it as the foot leaves the ground, and later on what is just ahead of it.</summary>
    public void Survey(in StepContext step, int leg, in Foot foot, SwingClearance way)
    {
        if (!foot.Plan.Aimed)
        {
            way.Clear();
        }

        if (step.Ground is IPlaneGround)
        {
            return;
        }

        LegRig shape = body.Legs[leg];
        Quaternion inverse = Rotation.Inverse(step.Frame.Rotation);
        Vector3 from = step.Frame.ToModel(foot.Plan.From.Position);
        Vector3 to = step.Frame.ToModel(foot.Plan.To.Position);
        Vector3 slopeFrom = Slope(Rotation.Rotate(inverse, foot.Plan.From.Normal));
        Vector3 slopeTo = Slope(Rotation.Rotate(inverse, foot.Plan.To.Normal));
        int first = 0;
        int last = SwingClearance.Knots;
        if (foot.Plan.Aimed)
        {
            first = SwingClearance.After(StepPhase.Along(foot.Swing));
            last = Math.Min(first + 1, last);
        }

        for (int i = first; i < last; i++)
        {
            float along = SwingClearance.At(i);
            if (Obstacle(step, shape, Vec.Lerp(from, to, along), Vec.Lerp(slopeFrom, slopeTo, along), out float height))
            {
                way.Feel(i, height, foot.Plan.Aimed ? Renewal : 1f);
            }
        }

        Vector3 course = to - from;
        float length = (float)Math.Sqrt((course.X * course.X) + (course.Z * course.Z));
        Vector3 ahead = course / Math.Max(length, 1e-6f);
        way.Span(length, shape.Toe, Vec.Dot(slopeFrom, ahead) - ahead.Y, Vec.Dot(slopeTo, ahead) - ahead.Y);
    }

    /// <summary>How far the ground is above a foot on its straight way: under its place, and under the toes of a sole that spreads, of legs out to the side, which carry it level.</summary>
    private bool Obstacle(in StepContext step, LegRig shape, Vector3 place, Vector3 slope, out float height)
    {
        height = float.MinValue;
        if (Down(step, place, out GroundHit hit))
        {
            height = step.Frame.ToModel(hit.Point).Y - place.Y;
        }

        Vector3 aside = Vec.Cross(Vector3.UnitY, shape.ToeDirection);
        for (int i = 0; shape.Lateral && IsFan(shape) && i < fan.Length; i++)
        {
            Vector3 toe = (shape.ToeDirection * (fan[i].Along * shape.Toe)) + (aside * (fan[i].Across * shape.HalfWidth));
            if (Down(step, place + toe, out hit))
            {
                height = Math.Max(height, step.Frame.ToModel(hit.Point).Y - place.Y - Vec.Dot(slope, toe));
            }
        }

        height = Math.Min(height, Highest * body.LegLength);
        return height > float.MinValue;
    }

    /// <summary>Whether a sole is long and wide: its toes spread.</summary>
    private static bool IsFan(LegRig shape) => Math.Min(shape.Toe, shape.HalfWidth) > LongSole * shape.Length;

    /// <summary>Rise of a plane along each level axis.</summary>
    private static Vector3 Slope(Vector3 normal) => new Vector3(-normal.X, 0f, -normal.Z) / Math.Max(normal.Y, Steepest);

    /// <summary>A sole as it will lie in the middle of its stance: turned with its leg on its middle.</summary>
    private static Sole LaidOut(LegRig shape, Vector3 home, Vector3 ahead)
    {
        Vector3 toes = shape.ToeDirection;
        Vector3 offset = Vector3.Zero;
        if (shape.Follows)
        {
            Quaternion follow = FollowingFoot.Heading(shape, Quaternion.Identity, home);
            toes = Rotation.Rotate(follow, toes);
            offset = shape.SoleMiddle - Rotation.Rotate(follow, shape.SoleMiddle);
        }

        return new Sole(Yawed(toes, ahead), Yawed(offset, ahead));
    }

    private static Vector3 Yawed(Vector3 v, Vector3 ahead) => new((v.X * ahead.Z) + (v.Z * ahead.X), v.Y, (v.Z * ahead.Z) - (v.X * ahead.X));

    /// <summary>Feels the ground under a rigid sole and lays it there: along the chords from heel to toes and, where it is wide, from side to side, as high as the highest ground under it asks.</summary>
    private void Feel(in StepContext step, LegRig shape, Vector3 target, in GroundHit hit, ref Sole sole)
    {
        float end = EndFraction * shape.Toe;
        float toe = Rise(step, shape, target, sole.At(end, 0f), hit, out sole.Toes);
        if (sole.Toes == SoleEnd.Wall && toe > 0f)
        {
            // Where toes that are raised to it end before the wall, it is no ground for them.
            float raised = shape.Toe * end / (float)Math.Sqrt((end * end) + (toe * toe));
            Rise(step, shape, target, sole.At(raised, 0f), hit, out SoleEnd tip);
            toe = tip == SoleEnd.Wall ? toe : 0f;
        }

        float heel = Rise(step, shape, target, sole.At(-EndFraction * shape.Heel, 0f), hit, out sole.Heel, out float ground);
        sole.Below = HeelFraction * ground;
        Rise(step, shape, target, sole.At(shape.Toe + (RollsOn * shape.Length), 0f), hit, out sole.Before);
        sole.Toes = shape.Fore > shape.Toe ? Bump(step, shape, target, sole.At(EndFraction * shape.Fore, 0f), hit, sole.Toes) : sole.Toes;
        sole.Heel = shape.Aft > shape.Heel ? Bump(step, shape, target, sole.At(-EndFraction * shape.Aft, 0f), hit, sole.Heel) : sole.Heel;
        sole.Slope = (toe - heel) / (EndFraction * (shape.Toe + shape.Heel));
        sole.StandOn(toe, end, 0f);
        if (shape.Toe > LongSole * shape.Length)
        {
            sole.StandOn(Rise(step, shape, target, sole.At(0.5f * end, 0f), hit, out sole.Middle), 0.5f * end, 0f);
        }

        FeelAcross(step, shape, target, hit, ref sole);
        sole.UnderHeel = sole.Above(heel, -EndFraction * shape.Heel, 0f);
    }

    /// <summary>The same from side to side of a wide one.</summary>
    private void FeelAcross(in StepContext step, LegRig shape, Vector3 target, in GroundHit hit, ref Sole sole)
    {
        if (shape.HalfWidth <= LongSole * shape.Length)
        {
            return;
        }

        float middle = Vec.Dot(shape.SoleMiddle, shape.ToeDirection);
        float side = SideFraction * shape.HalfWidth;
        float left = Rise(step, shape, target, sole.At(middle, side), hit, out _);
        float right = Rise(step, shape, target, sole.At(middle, -side), hit, out _);
        sole.Tilt = (left - right) / (2f * side);
        sole.StandOn(0.5f * (left + right), middle, 0f);
        for (int i = 0; IsFan(shape) && i < fan.Length; i++)
        {
            float along = fan[i].Along * shape.Toe;
            float across = fan[i].Across * shape.HalfWidth;
            sole.StandOn(Rise(step, shape, target, sole.At(along, across), hit, out SoleEnd tip), along, across);
            sole.Toes = tip == SoleEnd.Wall && !shape.Lateral ? tip : sole.Toes;
        }
    }

    /// <summary>What is below an end of a sole, where a heel or toes above it may be in a wall that the sole itself is not in.</summary>
    private SoleEnd Bump(in StepContext step, LegRig shape, Vector3 target, Vector3 beside, in GroundHit under, SoleEnd end)
    {
        Rise(step, shape, target, beside, under, out SoleEnd beyond);
        return beyond == SoleEnd.Wall ? beyond : end;
    }

    /// <summary>Rise of the ground with a normal over its way, at the steepest.</summary>
    private static float Steepness(Vector3 normal, Vector3 up) => Vec.Length(Vec.Reject(normal, up)) / Math.Max(Vec.Dot(normal, up), Steepest);

    /// <summary>The same where only that counts.</summary>
    private float Rise(in StepContext step, LegRig shape, Vector3 target, Vector3 beside, in GroundHit under, out SoleEnd end) => Rise(step, shape, target, beside, under, out end, out _);

    /// <summary>How much higher the ground is beside a foot's place than the plane of that place goes on, metres of the model; none where an edge or a wall is. Besides how much higher than the place it is, within bounds.</summary>
    private float Rise(in StepContext step, LegRig shape, Vector3 target, Vector3 beside, in GroundHit under, out SoleEnd end, out float height)
    {
        end = SoleEnd.Hangs;
        height = -MostBelow * shape.Length;
        if (!Down(step, target + beside, out GroundHit hit))
        {
            return 0f;
        }

        Vector3 up = step.Up;
        Vector3 way = hit.Point - under.Point;
        float scale = step.Frame.Scale;
        float higher = Vec.Dot(way, up);
        height = Scalar.Clamp(higher / scale, -MostBelow * shape.Length, MostBelow * shape.Length);
        float away = Vec.Length(Vec.Reject(way, up));
        float beyond = Math.Abs(higher) - (Math.Max(Steepness(hit.Normal, up), Steepness(under.Normal, up)) * away);
        end = beyond <= (higher < 0f ? EdgeDrop : WallRise) * shape.Length * scale ? SoleEnd.Stands : higher < 0f ? SoleEnd.Hangs : SoleEnd.Wall;
        if (end == SoleEnd.Hangs)
        {
            return 0f;
        }

        float rise = Vec.Dot(way, under.Normal) / (Vec.Dot(under.Normal, up) * scale);
        float bend = Math.Abs(rise) / Math.Max(BendOfGround * Vec.Length(beside), 1e-6f);
        return rise * Scalar.Clamp(2f - bend, 0f, 1f);
    }

    private bool Down(in StepContext step, Vector3 point, out GroundHit hit) => Down(step, point, 0f, out hit);

    /// <summary>Casts from above the slope on which the body is to below it, and so much farther both ways, leg lengths.</summary>
    private bool Down(in StepContext step, Vector3 point, float farther, out GroundHit hit)
    {
        float above = (Above + farther) * body.LegLength;
        Vector3 up = step.Up;
        Vector3 origin = step.Frame.ToWorld(new Vector3(point.X, above + (step.Slope * point.Z), point.Z));
        return step.Ground.Cast(origin, -up, (above + ((Below + farther) * body.LegLength)) * step.Frame.Scale, out hit) && Vec.Dot(hit.Normal, up) > Steepest;
    }
}
