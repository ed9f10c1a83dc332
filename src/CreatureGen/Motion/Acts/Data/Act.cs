using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Data;

namespace CreatureGen.Motion;

/// <summary>Something that a creature does on top of its way of moving: biting, eating, lying down. Data in parts of the body and units of the body, so that one act serves any build. Immutable.</summary>
public sealed class Act
{
    private readonly float[][] ends;
    private readonly float[][] speeds;
    private readonly ActPhase[] phases;

    /// <summary>An act of these phases. What its last phase does not bring back to 0 returns by itself.</summary>
    /// <param name="name">What games call it.</param>
    /// <param name="kind">What it is for.</param>
    /// <param name="phases">At least one.</param>
    /// <exception cref="ArgumentNullException">There is no name, or a phase is missing.</exception>
    /// <exception cref="ArgumentException">There is no phase.</exception>
    public Act(string name, ActKind kind, params ActPhase[] phases)
    {
        Name = name ?? throw new ArgumentNullException(nameof(name));
        Kind = kind;
        this.phases = (phases ?? throw new ArgumentNullException(nameof(phases))).ToArray();
        if (this.phases.Length == 0)
        {
            throw new ArgumentException("no phases; expected at least one", nameof(phases));
        }

        ends = new float[this.phases.Length][];
        for (int i = 0; i < ends.Length; i++)
        {
            ends[i] = i == 0 ? new float[ChannelCount] : (float[])ends[i - 1].Clone();
            foreach ((ActChannel channel, float value) in (this.phases[i] ?? throw new ArgumentNullException(FormattableString.Invariant($"{nameof(phases)}[{i}]"))).Ends)
            {
                ends[i][(int)channel] = value;
            }
        }

        speeds = Passage.Speeds(this.phases, ends);
    }

    private Act(Act other)
    {
        Name = other.Name;
        Kind = other.Kind;
        phases = other.phases;
        ends = other.ends;
        speeds = other.speeds;
        Needs = other.Needs;
        Builds = other.Builds;
        Tool = other.Tool;
        Footing = other.Footing;
        SnoutDown = other.SnoutDown;
        FallsFromAir = other.FallsFromAir;
        IsOnItself = other.IsOnItself;
    }

    /// <summary>What games call it.</summary>
    public string Name { get; }

    /// <summary>What it is for.</summary>
    public ActKind Kind { get; }

    /// <summary>What a body must have for it.</summary>
    public ActNeeds Needs { get; private set; }

    /// <summary>Which builds it is for; of several acts of a name a creature has the first that is for its build.</summary>
    public BodyBuild Builds { get; private set; } = BodyBuild.Any;

    /// <summary>What it brings to its target.</summary>
    public ActTool Tool { get; private set; }

    /// <summary>Whether it can be done at a walk.</summary>
    public ActFooting Footing { get; private set; }

    /// <summary>How far below level the snout points as the mouth reaches its target, radians.</summary>
    public float SnoutDown { get; private set; }

    /// <summary>Whether who is in the air, or falls, as it begins goes limp instead: it comes down, lies as it comes to lie, and gets up when it is to go on.</summary>
    public bool FallsFromAir { get; private set; }

    /// <summary>Whether it goes for its own fore leg where nobody says.</summary>
    internal bool IsOnItself { get; private set; }

    /// <summary>Its phases, in order.</summary>
    public IReadOnlyList<ActPhase> Phases => phases;

    /// <summary>Number of channels.</summary>
    internal static int ChannelCount => (int)ActChannel.Reach + 1;

    /// <summary>Values of all channels at the end of each phase.</summary>
    internal ReadOnlySpan<float[]> Ends => ends;

    /// <summary>How quickly they go there into the next, per time unit.</summary>
    internal ReadOnlySpan<float[]> Speeds => speeds;

    /// <summary>The phases without a call for each.</summary>
    internal ReadOnlySpan<ActPhase> AllPhases => phases;

    /// <summary>Whether it goes somewhere: its reach is used.</summary>
    internal bool Reaches => Tool != ActTool.None;

    /// <summary>The same for bodies that have these parts.</summary>
    public Act Needing(ActNeeds needs) => new(this) { Needs = needs };

    /// <summary>The same for these builds alone.</summary>
    public Act For(BodyBuild builds) => new(this) { Builds = builds };

    /// <summary>The same, bringing something to its target.</summary>
    /// <param name="tool">What.</param>
    /// <param name="snoutDown">How far below level the snout points there, radians, −1.5..1.5.</param>
    /// <exception cref="ArgumentException">The angle is not finite or out of its range.</exception>
    public Act With(ActTool tool, float snoutDown = 0f)
    {
        Finite.RequireWithin(snoutDown, -1.5f, 1.5f, nameof(snoutDown));
        return new Act(this) { Tool = tool, SnoutDown = snoutDown };
    }

    /// <summary>The same, done only on planted feet.</summary>
    public Act OnTheSpot() => new(this) { Footing = ActFooting.Standing };

    /// <summary>The same, by which who is in the air as it begins goes limp and falls.</summary>
    public Act FallingFromAir() => new(this) { FallsFromAir = true };

    /// <summary>The same, on the body's own fore leg where nobody says.</summary>
    internal Act OnItself() => new(this) { IsOnItself = true };

    /// <inheritdoc/>
    public override string ToString() => Name;

    /// <summary>Index of the phase at whose end it strikes or begins to sound; −1 for none.</summary>
    internal int ToldIn => IndexOf(ActMark.Contact) is var contact and >= 0 ? contact : IndexOf(ActMark.SoundBegin);

    /// <summary>Index of the phase at whose end something happens; −1 for none.</summary>
    internal int IndexOf(ActMark mark)
    {
        for (int i = 0; i < phases.Length; i++)
        {
            if (phases[i].Mark == mark)
            {
                return i;
            }
        }

        return -1;
    }
}
