using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;
using CreatureGen.Motion.Acts.Rehearsing;

namespace CreatureGen.Motion;

/// <summary>What a creature can do beside going: each act with its reach and times, and of what it cannot do, why. Worked out once for a creature, shared by all its animators.</summary>
public sealed class CreatureActs
{
    private readonly Rehearsal rehearsal;
    private readonly Lazy<ActAbility[]> all;

    internal CreatureActs(ActBody body, Rehearsal rehearsal)
    {
        Body = body;
        this.rehearsal = rehearsal;
        all = new Lazy<ActAbility[]>(TryAll);
    }

    /// <summary>The acts that come with the library, in order: those that it can do and those that it cannot.</summary>
    public IReadOnlyList<ActAbility> All => all.Value;

    /// <summary>Those that it can do.</summary>
    public IEnumerable<ActAbility> Possible => All.Where(ability => ability.IsPossible);

    /// <summary>The body as acts see it.</summary>
    internal ActBody Body { get; }

    /// <summary>An act by its name, whatever its case.</summary>
    /// <exception cref="ArgumentNullException">There is no name.</exception>
    /// <exception cref="ArgumentException">There is no act of that name; the message lists all.</exception>
    public ActAbility Find(string name)
    {
        if (name == null)
        {
            throw new ArgumentNullException(nameof(name));
        }

        foreach (ActAbility ability in all.Value)
        {
            if (string.Equals(ability.Act.Name, name, StringComparison.OrdinalIgnoreCase))
            {
                return ability;
            }
        }

        throw new ArgumentException(FormattableString.Invariant($"\"{name}\" is no act; expected one of {string.Join(", ", all.Value.Select(ability => ability.Act.Name))}"), nameof(name));
    }

    /// <summary>Tries an act of the game's own: how the creature can do it, or why not. Takes about a millisecond; keep what it gives.</summary>
    /// <exception cref="ArgumentNullException">There is no act.</exception>
    public ActAbility Rehearse(Act act) => rehearsal.Try(act ?? throw new ArgumentNullException(nameof(act)), rehearsal.Stage());

    /// <summary>The same a little at a time, for who may not wait: each step gives null, the last what <see cref="Rehearse"/> would. A step shows the body in at most some ten poses.</summary>
    /// <exception cref="ArgumentNullException">There is no act.</exception>
    public IEnumerable<ActAbility?> RehearseInSteps(Act act) => rehearsal.Steps(act ?? throw new ArgumentNullException(nameof(act)));

    /// <summary>Tries lying down on the belly, and no other act.</summary>
    internal ActAbility RehearseLyingOnBelly() => FirstPossible(ActLibrary.All.Where(act => act.Name == "Lie" && !Rehearsal.Uses(act, ActChannel.OnFlank)), rehearsal.Stage());

    /// <summary>How far the trunk goes over planted feet.</summary>
    internal TrunkRoom Room => rehearsal.Room;

    /// <summary>A stage of one's own.</summary>
    internal ActStage Stage() => rehearsal.Stage();

    private ActAbility[] TryAll()
    {
        ActStage stage = rehearsal.Stage();
        return ActLibrary.All.GroupBy(act => act.Name, StringComparer.Ordinal).Select(ways => FirstPossible(ways, stage)).ToArray();
    }

    /// <summary>The first way of doing an act that the body can do; where it can do none, why not the first of those that suit it best.</summary>
    private ActAbility FirstPossible(IEnumerable<Act> ways, ActStage stage)
    {
        ActAbility? refused = null;
        foreach (Act act in ways.OrderByDescending(Suits))
        {
            ActAbility ability = rehearsal.Try(act, stage);
            if (ability.IsPossible)
            {
                return ability;
            }

            refused ??= ability;
        }

        return refused!;
    }

    /// <summary>2 for an act whose build and parts the body has, 1 for one whose build it has, 0 for others.</summary>
    private int Suits(Act act) => (act.Builds & Body.Build) == 0 ? 0 : (act.Needs & ~Body.Has) == 0 ? 2 : 1;
}
