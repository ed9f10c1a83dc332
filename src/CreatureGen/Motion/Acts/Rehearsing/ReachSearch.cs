using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>
/// Finds how the trunk helps a tool to its target: one way after the other a step to and fro, kept where it brings the tool nearer without lifting a foot or sinking into the ground, with ever smaller steps.
/// Who may not wait goes on with it a way at a time; it allocates nothing.
/// Based on: R. Hooke and T. A. Jeeves, "Direct search solution of numerical and statistical problems" (1961).
/// </summary>
internal struct ReachSearch
{
    /// <summary>How near is there, parts of the unit, and what stops the search.</summary>
    public const float Near = 0.012f;

    /// <summary>How far a planted foot may be off, parts of its leg.</summary>
    private const float MaxSlip = 0.0045f;

    /// <summary>How deep the skin may be, parts of the body's length.</summary>
    private const float MaxSunk = 0.009f;

    private const int Sweeps = 14;
    private const float FirstStep = 0.5f;
    private const float LastStep = 0.03f;

    /// <summary>What an effort costs, beside the distance that is left: no more help than is needed.</summary>
    private const float Effort = 0.012f;

    /// <summary>What a foot that slips, or skin in the ground, costs.</summary>
    private const float Spoil = 50f;

    // Least and most of each way, in the order of the plan: ahead, yaw, back, chest, hips, pitch, aside.
    private static readonly float[] upright = { -0.35f, 0.40f, -0.35f, 0.35f, -0.5f, 0.4f, -0.15f, 0.9f, -0.15f, 0.6f, -0.25f, 0.25f, -0.15f, 0.15f };
    private static readonly float[] twoLegged = { -0.35f, 0.35f, -0.4f, 0.4f, -0.4f, 0.3f, 0f, 0f, -0.1f, 0.8f, -1.15f, 0.35f, -0.15f, 0.15f };
    private static readonly float[] lateral = { -0.30f, 0.30f, -0.3f, 0.3f, -0.4f, 0.4f, -0.5f, 0.9f, -0.5f, 0.9f, -0.3f, 0.3f, -0.2f, 0.2f };

    private readonly ActStage stage;
    private readonly ActBody body;
    private readonly Act act;
    private readonly ActGain gain;
    private readonly int phase;
    private readonly float[]? bounds;
    private ActAim aim;
    private float cost;
    private float step;
    private int sweep;
    private int way;
    private bool begun;
    private bool better;

    /// <summary>Begins to search.</summary>
    /// <param name="stage">Where it is tried.</param>
    /// <param name="body">Whose.</param>
    /// <param name="act">The act.</param>
    /// <param name="gain">Its gain.</param>
    /// <param name="aim">What is brought where; its plan is sought.</param>
    public ReachSearch(ActStage stage, ActBody body, Act act, ActGain gain, in ActAim aim)
        : this()
    {
        this.stage = stage;
        this.body = body;
        this.act = act;
        this.gain = gain;
        this.aim = aim with { Plan = default };
        phase = ReachedIn(act);
        step = FirstStep;
        bounds = body.Legs == null ? null : body.Legs.IsBiped ? twoLegged : body.Build is BodyBuild.Sprawling or BodyBuild.ManyLegged ? lateral : upright;
    }

    /// <summary>What is brought where, with the plan found so far.</summary>
    public readonly ActAim Aim => aim;

    /// <summary>How far the tool stays from its target by that plan, metres.</summary>
    public float Missing { get; private set; }

    private readonly bool GoesOn => bounds != null && sweep < Sweeps && step > LastStep && Missing > Near * body.Unit;

    /// <summary>Searches to the end.</summary>
    /// <param name="stage">Where it is tried.</param>
    /// <param name="body">Whose.</param>
    /// <param name="act">The act.</param>
    /// <param name="gain">Its gain.</param>
    /// <param name="aim">What is brought where; its plan is found.</param>
    /// <returns>How far the tool stays from its target, metres.</returns>
    public static float Find(ActStage stage, ActBody body, Act act, ActGain gain, ref ActAim aim)
    {
        var search = new ReachSearch(stage, body, act, gain, aim);
        while (search.Advance())
        {
            // Nobody waits here.
        }

        aim = search.aim;
        return search.Missing;
    }

    /// <summary>Tries the next way, to and fro. Whether more is to be tried.</summary>
    public bool Advance()
    {
        if (!begun)
        {
            begun = true;
            Missing = Try(aim.Plan, out cost);
            return GoesOn;
        }

        float width = bounds![(2 * way) + 1] - bounds[2 * way];
        better |= width > 0f && (Move(0.5f * step * width) || Move(-0.5f * step * width));
        way++;
        if (way < ReachPlan.Count)
        {
            return true;
        }

        step = better ? step : 0.5f * step;
        better = false;
        way = 0;
        sweep++;
        return GoesOn;
    }

    private bool Move(float by)
    {
        ReachPlan tried = aim.Plan;
        tried[way] = Scalar.Clamp(tried[way] + by, bounds![2 * way], bounds[(2 * way) + 1]);
        if (tried[way] == aim.Plan[way])
        {
            return false;
        }

        float left = Try(tried, out float triedCost);
        if (triedCost >= cost - 1e-4f)
        {
            return false;
        }

        aim = aim with { Plan = tried };
        cost = triedCost;
        Missing = left;
        return true;
    }

    /// <summary>The phase at whose end the tool is at its target.</summary>
    public static int ReachedIn(Act act)
    {
        int contact = act.IndexOf(ActMark.Contact);
        if (contact >= 0)
        {
            return contact;
        }

        int max = 0;
        for (int i = 1; i < act.Ends.Length; i++)
        {
            max = act.Ends[i][(int)ActChannel.Reach] > act.Ends[max][(int)ActChannel.Reach] ? i : max;
        }

        return max;
    }

    private readonly float Try(in ReachPlan plan, out float triedCost)
    {
        stage.Show(act, phase, 1, gain, aim with { Plan = plan });
        float missing = Vec.Distance(stage.PlaceOf(aim.Tool, aim.Mirrored), aim.Target);
        float effort = 0f;
        for (int i = 0; i < ReachPlan.Count; i++)
        {
            effort += plan[i] * plan[i];
        }

        triedCost = (missing / body.Unit) + (Effort * effort) + (Spoil * Math.Max(0f, stage.Slip() - MaxSlip)) + (Spoil * Math.Max(0f, stage.Sunk() - MaxSunk));
        return missing;
    }
}
