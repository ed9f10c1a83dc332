using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Threading;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;
using CreatureGen.Motion.Modes;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>Tries acts on a body before it performs them: what it lacks, how much of it its legs and the ground leave, where it reaches.</summary>
internal sealed class Rehearsal
{
    /// <summary>Moments of a phase at which it is looked at, of each cycle in which trunk or feet swing in it, and of one in which it rolls over, on which horns and feelers sweep the ground; and how many in a step.</summary>
    private const int Moments = 7;
    private const int MomentsOfCycle = 8;
    private const int MomentsOfRoll = 16;
    private const int MomentsOfStep = 10;
    private const double Offbeat = 0.37;

    /// <summary>How far a planted foot may be off, parts of its leg, and how deep the skin may be, parts of the body's length.</summary>
    private const float MaxSlip = 0.006f;
    private const float MaxSunk = 0.011f;

    /// <summary>The first of a reflex, which begins before what the creature does by itself as it stands has died away.</summary>
    private const float MaxSlipOfReflex = 0.003f;

    /// <summary>Part of the reach by which a contact may miss.</summary>
    public const float MaxMiss = 0.025f;

    private const int Halvings = 5;

    // What is tried, in order: less of the way down before less of all; where legs do not fold less of the trunk between these: head and tail of a body on many feet move all the same.
    private static readonly float[] downs = { 1f, 0.9f, 0.8f, 0.7f, 0.6f, 0.5f, 0.4f };
    private static readonly ActGain[] foldedGains = (from whole in new[] { 1f, 0.8f, 0.6f, 0.45f, 0.33f } from down in downs select new ActGain(whole, down)).ToArray();
    private static readonly ActGain[] gains = foldedGains[..downs.Length]
        .Concat(from trunk in new[] { 0.6f, 0.3f } from down in new[] { 1f, 0.7f, 0.4f } select new ActGain(1f, down, trunk))
        .Concat(foldedGains[downs.Length..]).ToArray();

    private static readonly ActGain[] reachingGains = { ActGain.Full, new(1f, 0.5f), new(0.7f, 0.7f), new(0.5f, 0.5f), new(0.35f, 0.5f) };

    private readonly ActBody body;
    private readonly Func<ILocomotionMode?> mode;
    private readonly FoldedLegs legs;
    private TrunkRoom? room;

    public Rehearsal(ActBody body, Func<ILocomotionMode?> mode)
    {
        this.body = body;
        this.mode = mode;
        legs = new FoldedLegs(body.Legs?.Legs.Length ?? 0);
    }

    /// <summary>How far the trunk goes over planted feet; found when it is first asked for.</summary>
    public TrunkRoom Room
    {
        get
        {
            foreach (TrunkRoom? _ in FindRoom())
            {
                // Nobody waits here.
            }

            return room!;
        }
    }

    /// <summary>A stage of one's own.</summary>
    public ActStage Stage() => new(body, mode(), Room);

    /// <summary>Finds out how a body does an act.</summary>
    public ActAbility Try(Act act, ActStage stage)
    {
        ActAbility? found = null;
        foreach (ActAbility? step in Steps(act, stage))
        {
            found = step;
        }

        return found!;
    }

    /// <summary>The same a little at a time: nothing, and with the last what was found.</summary>
    public IEnumerable<ActAbility?> Steps(Act act)
    {
        foreach (TrunkRoom? _ in FindRoom())
        {
            yield return null;
        }

        foreach (ActAbility? step in Steps(act, Stage()))
        {
            yield return step;
        }
    }

    private IEnumerable<ActAbility?> Steps(Act act, ActStage stage)
    {
        float[] ends = ActPlayer.EndsOf(act, body.TimeUnit(MotionSettings.Default.Gravity) * ActTempo.Of(act, body));
        if (Lacks(act) is string lack)
        {
            yield return new ActAbility(act, lack, default, ends, default(ActAim), () => null);
            yield break;
        }

        if (Folds(act))
        {
            foreach (float _ in FindFolds())
            {
                yield return null;
            }
        }

        if (Uses(act, ActChannel.OnFlank) && legs.Flank == 0f)
        {
            yield return new ActAbility(act, "it would not stay on its flank or its back", default, ends, default(ActAim), () => null);
            yield break;
        }

        Vector3 usual = default;
        foreach (Vector3? target in act.Reaches ? UsualTarget.Steps(act, body, stage) : [])
        {
            usual = target ?? usual;
            yield return null;
        }

        string? refusal = null;
        foreach (ActGain gain in GainsOf(act))
        {
            var aim = new ActAim(act.Tool, false, usual, act.SnoutDown, default);
            refusal = null;
            if (act.Reaches)
            {
                var search = new ReachSearch(stage, body, act, gain, aim);
                while (search.Advance())
                {
                    yield return null;
                }

                aim = search.Aim;
                float missing = search.Missing;
                refusal = missing > MaxMiss * ReachLength(act, body) ? FormattableString.Invariant($"it stays {missing:0.00} m from where it would reach") : null;
            }

            foreach (string? spoilt in refusal == null ? Spoils(act, stage, gain, aim) : [])
            {
                refusal = spoilt;
                yield return null;
            }

            if (refusal == null)
            {
                yield return new ActAbility(act, null, gain, ends, aim, () => act.Reaches ? ReachOf(act, gain, usual) : null);
                yield break;
            }
        }

        yield return new ActAbility(act, refusal, default, ends, new ActAim(act.Tool, false, usual, act.SnoutDown, default), () => null);
    }

    /// <summary>How much of an act is tried, the most first.</summary>
    private static ActGain[] GainsOf(Act act)
    {
        if (act.Reaches)
        {
            return reachingGains;
        }

        return Folds(act) ? foldedGains : gains;
    }

    /// <summary>Finds how far the trunk goes, unless that is known.</summary>
    private IEnumerable<TrunkRoom?> FindRoom()
    {
        if (room != null)
        {
            yield break;
        }

        foreach (TrunkRoom? found in RoomSearch.Steps(body, StageWithoutRoom(legs), legs))
        {
            // Others may seek it meanwhile: what was found first stays.
            Interlocked.CompareExchange(ref room, found, null);
            yield return found;
            if (room != null)
            {
                yield break;
            }
        }
    }

    /// <summary>Finds where legs fold to when the first act asks for it: it takes ten times as long as all else here, and most creatures never lie down.</summary>
    private IEnumerable<float> FindFolds()
    {
        if (legs.IsFound || body.Legs == null)
        {
            yield break;
        }

        // Others perform, and search, meanwhile: they see all of it or nothing.
        var found = new FoldedLegs(body.Legs.Legs.Length);
        foreach (float cost in FoldSearch.Steps(body, StageWithoutRoom(found), found))
        {
            yield return cost;
        }

        legs.Take(found);
    }

    private ActStage StageWithoutRoom(FoldedLegs shown) => new(body, mode(), TrunkRoom.Any(shown));

    private static bool Folds(Act act) => Uses(act, ActChannel.ForeFold) || Uses(act, ActChannel.HindFold) || Uses(act, ActChannel.OnFlank);

    public static bool Uses(Act act, ActChannel channel)
    {
        foreach (float[] end in act.Ends)
        {
            if (end[(int)channel] != 0f)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Length by which misses are measured, metres: of the neck, the leg or the arm that reaches, and of what the trunk adds.</summary>
    public static float ReachLength(Act act, ActBody body) => act.Tool == ActTool.Tail ? body.Tail.Length : body.Unit;

    /// <summary>What the body lacks, in words.</summary>
    private string? Lacks(Act act)
    {
        if ((act.Builds & body.Build) == 0)
        {
            return FormattableString.Invariant($"it is not for a body that is {BuildNames.Of(body.Build)}");
        }

        ActNeeds missing = act.Needs & ~body.Has;
        if (missing != ActNeeds.None)
        {
            return "it has no " + BuildNames.Of(missing);
        }

        return act.Tool != ActTool.None && body.Tools.JointOf(act.Tool, false) < 0 ? "it has nothing to do it with" : null;
    }

    /// <summary>What goes wrong in the course of an act, in words, one phase a step, or less where it swings: null for nothing, up to the first that something spoils.</summary>
    private IEnumerable<string?> Spoils(Act act, ActStage stage, ActGain gain, ActAim aim)
    {
        for (int phase = 0; phase < act.Phases.Count; phase++)
        {
            int moments = MomentsOf(act.Phases[phase]);
            for (int k = 1; k <= moments; k++)
            {
                // Out of step with waves; the last is the end.
                stage.Show(act, phase, k == moments ? 1 : (k - Offbeat) / moments, gain, aim);
                if (body.Legs != null && stage.Slip() > (act.Kind == ActKind.Reflex ? MaxSlipOfReflex : MaxSlip))
                {
                    yield return "its feet would not stay where they stand";
                    yield break;
                }

                bool rests = k == moments && act.Phases[phase].Lasts;
                if (stage.Sunk() + (rests ? stage.Lifted() : 0f) > MaxSunk)
                {
                    yield return "it would sink into the ground";
                    yield break;
                }

                if (k % MomentsOfStep == 0)
                {
                    yield return null;
                }
            }

            yield return null;
        }
    }

    /// <summary>Moments at which a phase is looked at: enough of them to see what comes to the ground in a roll, and the ends of swings that feet or the ground bound, and one more, so that each cycle is seen at places of its own.</summary>
    private static int MomentsOf(ActPhase phase)
    {
        float cycles = 0f;
        foreach (ActWave wave in phase.AllWaves)
        {
            bool moves = wave.Channel is <= ActChannel.BackTwist or (>= ActChannel.ForeFeetUp and <= ActChannel.HindFootPitch);
            cycles = moves ? Math.Max(cycles, wave.Cycles) : cycles;
        }

        bool rollsOver = phase.Ends.Any(end => end.Channel == ActChannel.OnFlank);
        return Math.Max(rollsOver ? MomentsOfRoll : Moments, (int)(MomentsOfCycle * cycles) + 1);
    }

    private ActReach? ReachOf(Act act, ActGain gain, Vector3 usual)
    {
        ActStage stage = Stage();
        float far = body.Size + body.Unit;
        return new ActReach(
            usual.Z - Farthest(-Vector3.UnitZ, far),
            usual.Z + Farthest(Vector3.UnitZ, far),
            usual.Y - Farthest(-Vector3.UnitY, Math.Max(usual.Y, 0f)),
            usual.Y + Farthest(Vector3.UnitY, far),
            Farthest(Vector3.UnitX, far));

        // How far from the usual target in a direction it still reaches.
        float Farthest(Vector3 direction, float max)
        {
            float near = 0f;
            float end = max;
            for (int i = 0; i < Halvings && max > 0f; i++)
            {
                float at = i == 0 ? end : 0.5f * (near + end);
                var aim = new ActAim(act.Tool, false, usual + (direction * at), act.SnoutDown, default);
                bool there = ReachSearch.Find(stage, body, act, gain, ref aim) <= MaxMiss * ReachLength(act, body);
                near = there ? at : near;
                end = there ? end : at;
            }

            return near;
        }
    }
}
