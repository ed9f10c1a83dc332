using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>Watches a creature on its feet: whether they slip, sink or stumble, how many are down, and whether the body keeps to the ground. Up is +Y, the scale 1.</summary>
internal sealed class FootingWatch
{
    /// <summary>Vertices of a foot that are looked at, at most.</summary>
    private const int MaxVertices = 300;

    /// <summary>How far above and below the ground is looked for, leg lengths.</summary>
    private const float Lookout = 40f;

    // The middle of a swing.
    private const float SwingFrom = 0.3f;
    private const float SwingTo = 0.75f;

    private readonly CreatureAnimator animator;
    private readonly CourseSurface surface;
    private readonly LegRig[] legs;
    private readonly float legLength;
    private readonly FootSkin[] skins;
    private readonly StanceWatch[] stances;
    private readonly Matrix4x4[] matrices;
    private readonly Vector3[] points = new Vector3[MaxVertices];
    private readonly float[] heights = new float[MaxVertices];
    private readonly List<float> slips = new();
    private int frames;
    private float penetration;
    private float? clearance;
    private float lag;
    private bool isLost;
    private int lost;
    private float lostSeconds;
    private int minSupport = int.MaxValue;
    private long support;
    private float flight;
    private float longestFlight;

    public FootingWatch(CreatureAnimator animator, LeggedBody body, CourseSurface surface)
    {
        this.animator = animator;
        this.surface = surface;
        legs = body.Legs;
        legLength = body.LegLength;
        matrices = new Matrix4x4[body.Skeleton.Count];
        skins = Array.ConvertAll(body.Legs, leg => new FootSkin(body.Subject, leg.Ankle, leg.Ball, leg.Length));
        stances = Array.ConvertAll(skins, skin => new StanceWatch(Sampled(skin), legLength));
    }

    /// <summary>Watches an update that ended on its feet.</summary>
    /// <param name="dt">Its seconds.</param>
    public void Stand(float dt)
    {
        SkinMatrices.Fill(animator.Profile.Subject.Skeleton, animator.ModelPose, matrices);
        foreach (MotionEvent happened in animator.Events)
        {
            if (happened.Kind == MotionEventKind.FootUp)
            {
                Lift(happened.Foot);
            }
        }

        int down = 0;
        for (int i = 0; i < skins.Length; i++)
        {
            FootReport foot = animator.Foot(i);
            down += foot.Phase == FootPhase.Stance ? 1 : 0;
            WatchFoot(i, foot);
        }

        frames++;
        support += down;
        minSupport = Math.Min(minSupport, down);
        flight = down > 0 ? 0f : flight + dt;
        longestFlight = Math.Max(longestFlight, flight);
        WatchRoot(dt);
    }

    /// <summary>An update that did not end on its feet.</summary>
    public void LeaveGround()
    {
        for (int i = 0; i < skins.Length; i++)
        {
            Lift(i);
        }

        flight = 0f;
        isLost = false;
    }

    /// <summary>A report with what was seen; as it was when nothing was.</summary>
    public CourseReport AddTo(CourseReport report)
    {
        if (frames == 0)
        {
            return report;
        }

        for (int i = 0; i < skins.Length; i++)
        {
            Lift(i);
        }

        slips.Sort();
        bool stood = slips.Count > 0;
        return report with
        {
            StanceSlip = stood ? slips[slips.Count - 1] / legLength : null,
            StanceSlip99 = stood ? slips[(int)(0.99 * (slips.Count - 1))] / legLength : null,
            Stances = slips.Count,
            Penetration = penetration / legLength,
            Clearance = clearance / legLength,
            RootLag = lag / legLength,
            LostGround = lost,
            LostGroundSeconds = lostSeconds,
            MinSupport = minSupport,
            MeanSupport = support / (float)frames,
            LongestFlight = longestFlight,
        };
    }

    private static int Sampled(FootSkin skin) => Math.Min(skin.Count, MaxVertices);

    private void Lift(int foot)
    {
        if (stances[foot].Lift() is float slip)
        {
            slips.Add(slip);
        }
    }

    private void WatchFoot(int index, in FootReport foot)
    {
        FootSkin skin = skins[index];
        int count = Sampled(skin);
        if (count == 0)
        {
            return;
        }

        RootPlace root = animator.Root;
        RootPlace frame = surface.Frame;
        float lowest = float.MaxValue;
        for (int i = 0; i < count; i++)
        {
            Vector3 point = root.ToWorld(skin.At(i * skin.Count / count, matrices));
            points[i] = frame.ToModel(point);
            heights[i] = surface.HeightAt(point, Lookout * legLength) is float height ? point.Y - height : legLength;
            lowest = Math.Min(lowest, heights[i]);
            if (-heights[i] > penetration)
            {
                penetration = Math.Max(penetration, surface.DepthOf(point, -heights[i], Lookout * legLength));
            }
        }

        if (foot.Phase == FootPhase.Stance)
        {
            stances[index].Stand(points.AsSpan(0, count), heights.AsSpan(0, count), lowest);
            return;
        }

        Lift(index);
        if (foot.Progress > SwingFrom && foot.Progress < SwingTo)
        {
            clearance = clearance is float known ? Math.Min(known, lowest) : lowest;
        }
    }

    private void WatchRoot(float dt)
    {
        float reach = Lookout * legLength;
        RootPlace place = animator.Root;
        Vector3 root = place.Position;
        float sum = 0f;
        int found = 0;
        foreach (LegRig leg in legs)
        {
            if (surface.HeightAt(place.ToWorld(leg.HipRest), reach) is float height)
            {
                sum += height;
                found++;
            }
        }

        lag = found > 0 ? Math.Max(lag, Math.Abs(root.Y - (sum / found))) : lag;
        bool lostNow = !(surface.HeightAt(root, reach) is float below && Math.Abs(root.Y - below) <= legLength);
        lost += lostNow && !isLost ? 1 : 0;
        lostSeconds += lostNow ? dt : 0f;
        isLost = lostNow;
    }
}
