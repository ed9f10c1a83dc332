using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Poses;

/// <summary>
/// Lets a standing foot that its joints turn roll from edge to edge without slipping: from update to update what of its sole is down stays where it was.
/// A foot that is twisted as it comes from one edge onto the next does not come back to where it would be if it lay as it should; by how much it is away from there it keeps for the rest of its stance, and gives up in its swing.
/// </summary>
internal static class SoleHold
{
    /// <summary>Height above the lowest point of the sole at which another counts half as much as it, leg lengths.</summary>
    private const float Touch = 0.006f;

    /// <summary>How far it may be away at most, leg lengths: farther on it slips.</summary>
    private const float Farthest = 0.15f;

    /// <summary>By how much a foot rolls down in a step at most, radians.</summary>
    private const float RollStep = 0.02f;

    /// <summary>Takes a foot to where it is away from its place, as far as it still is.</summary>
    /// <param name="state">Its state.</param>
    /// <param name="pose">Where the leg has to bring the foot.</param>
    public static void Carry(ref Foot state, ref FootPose pose)
    {
        if (state.Leg.Turned.Away == Vector3.Zero)
        {
            return;
        }

        float kept = HipLimit.Of(state).Standing;
        if (kept == 0f)
        {
            state.Leg.Turned.Away = Vector3.Zero;
            return;
        }

        pose.MoveBy(Rotation.Rotate(state.Path.Planned, state.Leg.Turned.Away) * kept);
    }

    /// <summary>Rolls down a foot that has come down turned in this update, step by step: what a long update leaves out of its roll would be missing from where it stands.</summary>
    /// <param name="leg">Whose.</param>
    /// <param name="level">How the foot would lie now.</param>
    /// <param name="state">Its state: remembers how it lay just before.</param>
    /// <param name="lies">How it lies now: is taken to where it has come to by then.</param>
    public static void RollDown(LegRig leg, in FootPose level, ref Foot state, ref FootPose lies)
    {
        float rolled = state.Path.RolledDown;
        if (rolled == 0f)
        {
            return;
        }

        Vector3 carried = state.Leg.Turned.Away;
        int steps = (int)Math.Ceiling(Math.Abs(rolled) / RollStep);
        for (int i = steps; i > 0; i--)
        {
            FootPose then = RolledBack(leg, level, lies, rolled * i / steps, state);
            then.MoveBy(Rotation.Rotate(state.Path.Planned, state.Leg.Turned.Away - carried));
            Keep(leg, ref state, ref then);
            Remember(ref state, then);
        }

        lies.MoveBy(Rotation.Rotate(state.Path.Planned, state.Leg.Turned.Away - carried));
    }

    /// <summary>Takes a foot that stands turned to where what of its sole is down stays, however the ground slants.</summary>
    /// <param name="leg">Whose.</param>
    /// <param name="state">Its state.</param>
    /// <param name="pose">Where the leg has to bring the foot.</param>
    public static void Keep(LegRig leg, ref Foot state, ref FootPose pose)
    {
        ref TurnedFoot turned = ref state.Leg.Turned;
        if (!turned.Stood)
        {
            return;
        }

        Quaternion inverse = Rotation.Inverse(state.Path.Planned);
        Vector3 normal = Rotation.Rotate(inverse, state.Path.Normal);
        Vector3 way = turned.Ball - Rotation.Rotate(inverse, pose.Ball - state.Path.Base);
        way -= Down(leg, normal, turned, Rotation.Multiply(inverse, pose.Foot), Rotation.Multiply(inverse, pose.Toes));
        Vector3 away = turned.Away + way - (normal * Vec.Dot(normal, way));
        float most = Farthest * leg.Length;
        away *= most / Math.Max(Vec.Length(away), most);
        pose.MoveBy(Rotation.Rotate(state.Path.Planned, away - turned.Away));
        turned.Away = away;
    }

    /// <summary>Remembers how a foot stands turned.</summary>
    /// <param name="state">Its state.</param>
    /// <param name="pose">How its leg was posed.</param>
    public static void Remember(ref Foot state, in FootPose pose)
    {
        Quaternion inverse = Rotation.Inverse(state.Path.Planned);
        ref TurnedFoot turned = ref state.Leg.Turned;
        turned.Stood = true;
        turned.Foot = Rotation.Multiply(inverse, pose.Foot);
        turned.Toes = Rotation.Multiply(inverse, pose.Toes);
        turned.Ball = Rotation.Rotate(inverse, pose.Ball - state.Path.Base);
    }

    /// <summary>How a foot lay before it rolled down by an angle, turned as it is now.</summary>
    private static FootPose RolledBack(LegRig leg, in FootPose level, in FootPose lies, float angle, in Foot state)
    {
        float pitch = state.Path.Posture.Shown.Pitch;
        float toes = FootRoll.SolePitch(leg, pitch);
        float toesThen = FootRoll.SolePitch(leg, pitch - angle);
        Quaternion ground = Rotation.Multiply(level.Toes, AxisRotation.About(leg.RollAxis, -toes));
        Quaternion footBack = AxisRotation.About(leg.RollAxis, -angle);
        Quaternion toesBack = AxisRotation.About(leg.RollAxis, toesThen - toes);
        FootPose then = level;
        then.Foot = Rotation.Multiply(level.Foot, footBack);
        then.Toes = Rotation.Multiply(level.Toes, toesBack);
        then.Ball += Rotation.Rotate(ground, FootRoll.BallAt(leg, state, toesThen) - FootRoll.BallAt(leg, state, toes));
        LimitRelaxation.Turn(leg, state.Path.Normal, Rotation.Multiply(lies.Foot, footBack), Rotation.Multiply(lies.Toes, toesBack), toesThen, 1f, ref then);
        return then;
    }

    /// <summary>How far the turn alone would take what of the sole is down: half of it by how the foot lay, half by how it lies, so that there and back again comes to nothing.</summary>
    private static Vector3 Down(LegRig leg, Vector3 normal, in TurnedFoot turned, Quaternion foot, Quaternion toes)
    {
        Span<Vector3> before = stackalloc Vector3[SoleExtent.Directions];
        Span<Vector3> after = stackalloc Vector3[SoleExtent.Directions];
        float lowest = SoleEdge.Lay(leg, normal, turned.Foot, turned.Toes, before) + SoleEdge.Lay(leg, normal, foot, toes, after);
        float touch = 2f * Touch * leg.Length;
        Vector3 way = default;
        float sum = 0f;
        for (int i = 0; i < after.Length; i++)
        {
            float above = (Vec.Dot(normal, before[i] + after[i]) - lowest) / touch;
            float weight = 1f / (1f + (above * above));
            weight *= weight;
            way += (after[i] - before[i]) * weight;
            sum += weight;
        }

        return way / sum;
    }
}
