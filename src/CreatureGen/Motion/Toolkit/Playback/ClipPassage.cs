using System;
using System.Collections.Generic;

namespace CreatureGen.Motion.Toolkit;

/// <summary>The part of a clip that was played in a step: from one moment of it to another, around any number of times.</summary>
/// <remarks>
/// It holds its first moment and not its last, in either direction the earlier of the two: passages that follow each other share no event and miss none. Only the last moment of a clip that stays there belongs to the
/// passage that reaches it. In a clip that loops, its last moment is its first.
/// </remarks>
public readonly struct ClipPassage
{
    /// <summary>Most rounds in a step that are told; a step of more is none of a game.</summary>
    internal const int MaxRounds = 1000;

    // Kept at the time: in a blend whose weights change, other events may count in the next step.
    private readonly IReadOnlyList<ClipEvent> events;
    private readonly float span;
    private readonly ClipEnd end;

    internal ClipPassage(IClip clip, double from, double to, int rounds)
    {
        events = clip.Events;
        span = clip.EventSpan;
        end = clip.End;
        From = from;
        To = to;
        Rounds = rounds;
    }

    /// <summary>The part of the clip that had been played before, 0..1.</summary>
    public double From { get; }

    /// <summary>The part of the clip that has been played after, 0..1.</summary>
    public double To { get; }

    /// <summary>How often the clip's end was passed; below 0 for its beginning, backwards.</summary>
    public int Rounds { get; }

    /// <summary>The events on the way, in the order in which they were passed. Nothing is allocated.</summary>
    public Enumerator GetEnumerator() => new(this);

    /// <summary>Goes through the events of a passage.</summary>
    public struct Enumerator
    {
        private readonly ClipPassage passage;
        private readonly int direction;

        // Events at the very end of a loop, which belong to its beginning.
        private readonly int ends;
        private int round;
        private int index;

        internal Enumerator(in ClipPassage passage)
        {
            this.passage = passage;
            direction = passage.Rounds < 0 || (passage.Rounds == 0 && passage.To < passage.From) ? -1 : 1;
            ends = 0;
            while (passage.end == ClipEnd.Loops && ends < passage.events.Count && passage.events[passage.events.Count - 1 - ends].Time >= passage.span)
            {
                ends++;
            }

            round = 0;
            index = direction > 0 ? -1 : passage.events.Count;
        }

        /// <summary>The event that was found.</summary>
        public readonly ClipEvent Current
        {
            get
            {
                int listed = index - ends;
                return passage.events[listed < 0 ? listed + passage.events.Count : listed];
            }
        }

        /// <summary>Looks for the next event.</summary>
        public bool MoveNext()
        {
            int count = passage.events.Count;
            while (true)
            {
                index += direction;
                if ((uint)index < (uint)count)
                {
                    if (Holds())
                    {
                        return true;
                    }
                }
                else if (count == 0 || round == passage.Rounds)
                {
                    return false;
                }
                else
                {
                    round += direction;
                    index = direction > 0 ? -1 : count;
                }
            }
        }

        private readonly bool Holds()
        {
            double at = index < ends ? 0 : Current.Time / (double)passage.span;
            if (at >= 1)
            {
                return direction > 0 && passage.To >= 1 && passage.From < 1;
            }

            bool first = round == 0;
            bool last = round == passage.Rounds;
            return direction > 0
                ? at >= (first ? passage.From : 0) && at < (last ? passage.To : 1)
                : at >= (last ? passage.To : 0) && at < (first ? passage.From : 1);
        }
    }
}
