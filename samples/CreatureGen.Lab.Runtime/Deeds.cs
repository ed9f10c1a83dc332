using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion;

namespace CreatureGen.Lab.Runtime;

/// <summary>What a creature does beside going. An act is tried on its body when somebody first asks for it: all of them at once would keep everybody on the stage waiting.</summary>
internal sealed class Deeds(CreatureAnimator animator)
{
    private readonly Dictionary<string, ActAbility> tried = new(StringComparer.OrdinalIgnoreCase);
    private readonly Dictionary<string, IEnumerator<ActAbility?>> trials = new(StringComparer.OrdinalIgnoreCase);

    /// <summary>How the creature does an act, or why it does not.</summary>
    public ActAbility Find(string name)
    {
        Try(name, double.PositiveInfinity);
        return tried[name];
    }

    /// <summary>Goes on trying an act for some milliseconds. Whether it is known now how the creature does it.</summary>
    public bool Try(string name, double milliseconds)
    {
        if (tried.ContainsKey(name))
        {
            return true;
        }

        if (!trials.TryGetValue(name, out IEnumerator<ActAbility?>? trial))
        {
            trials[name] = trial = Trial(name).GetEnumerator();
        }

        long begin = Stopwatch.GetTimestamp();
        while (trial.MoveNext())
        {
            if (trial.Current is { } ability)
            {
                tried[name] = ability;
                trials.Remove(name);
                return true;
            }

            if (Stopwatch.GetElapsedTime(begin).TotalMilliseconds > milliseconds)
            {
                return false;
            }
        }

        throw new ArgumentException("\u201c" + name + "\u201d is no act");
    }

    /// <summary>Begins an act.</summary>
    /// <returns>Empty, or why not.</returns>
    public string Perform(string name, in ActTarget target)
    {
        ActAbility ability = Find(name);
        return ability.IsPossible ? animator.Perform(ability, target).Reason ?? "" : ability.Refusal!;
    }

    /// <summary>Begins the first of some acts that the creature can do where it is.</summary>
    public bool PerformAny(ReadOnlySpan<string> names)
    {
        foreach (string name in names)
        {
            if (Perform(name, ActTarget.Usual).Length == 0)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The first way of doing an act that the creature can do; if it can do none, why not the first.</summary>
    private IEnumerable<ActAbility?> Trial(string name)
    {
        ActAbility? refused = null;
        foreach (Act act in ActLibrary.All.Where(act => string.Equals(act.Name, name, StringComparison.OrdinalIgnoreCase)))
        {
            foreach (ActAbility? step in animator.Acts.RehearseInSteps(act))
            {
                if (step is { IsPossible: true })
                {
                    yield return step;
                    yield break;
                }

                refused ??= step;
                yield return null;
            }
        }

        if (refused != null)
        {
            yield return refused;
        }
    }

    /// <summary>A blow of a strength: 0.3 makes it stagger, 0.7 knocks most over.</summary>
    public static Vector3 Impulse(Actor actor, float x, float z, float strength)
    {
        float length = (float)Math.Sqrt((x * x) + (z * z));
        float speed = strength * (float)Math.Sqrt(MotionSettings.Default.Gravity * 0.5f * actor.Abilities.Height);
        return length > 0f ? new Vector3(x / length, 0.1f, z / length) * (speed * actor.Creature.Mass.Mass) : Vector3.Zero;
    }
}
