using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using CreatureGen.Creatures;
using CreatureGen.Events;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Tests.Events;

/// <summary>How many of an animator's own footsteps a rule finds, by gait.</summary>
internal sealed class FootstepFigures
{
    /// <summary>Seconds from a step within which it is found.</summary>
    public const float Near = 0.05f;

    private readonly SortedDictionary<string, Row> rows = new(StringComparer.Ordinal);

    /// <summary>Of all gaits together.</summary>
    public Row All => rows.Values.Aggregate(default(Row), (sum, row) => sum + row);

    /// <summary>A row of each gait.</summary>
    public IReadOnlyDictionary<string, Row> Gaits => rows;

    /// <summary>Counts what is found in all clips of a creature that loop and have footsteps.</summary>
    public void Add(Creature creature)
    {
        foreach (Clip clip in ClipBaker.Bake(creature).Where(clip => clip.End == ClipEnd.Loops))
        {
            ClipEvent[] steps = clip.Events.Where(e => e.Name == "footstep").ToArray();
            if (steps.Length > 0)
            {
                Add(clip.Name, steps, AngularEventDetector.Find(clip, creature.Skeleton, AngularRules.Footstep).Events.Select(e => (e.Time, e.Joint)), clip.Duration);
            }
        }
    }

    /// <summary>Counts what is found live, in so many loops of each clip after the first two, which teach.</summary>
    public void AddLive(Creature creature, int loops)
    {
        Skeleton skeleton = creature.Skeleton;
        var pose = new Pose(new System.Numerics.Quaternion[skeleton.Count], new System.Numerics.Vector3[skeleton.Count]);
        var model = new Pose(new System.Numerics.Quaternion[skeleton.Count], new System.Numerics.Vector3[skeleton.Count]);
        foreach (Clip clip in ClipBaker.Bake(creature).Where(clip => clip.End == ClipEnd.Loops))
        {
            ClipEvent[] steps = clip.Events.Where(e => e.Name == "footstep").ToArray();
            if (steps.Length == 0)
            {
                continue;
            }

            var stream = new AngularEventStream(skeleton, AngularRules.Footstep);
            int frames = (int)(clip.Duration * 60f * (loops + 2));
            var found = new List<(float Time, string Joint)>();
            for (int i = 0; i < frames; i++)
            {
                float at = i / 60f;
                clip.Sample(ClipTime.Within(at, clip.Duration, ClipEnd.Loops), pose);
                ForwardKinematics.LocalToModel(skeleton, pose, model);
                stream.Update(pose, model, 1f / 60f);
                foreach (AngularMoment moment in stream.Found)
                {
                    if (at - moment.SecondsAgo > 2f * clip.Duration)
                    {
                        found.Add((at - moment.SecondsAgo, skeleton.Joints[moment.Joint].Name));
                    }
                }
            }

            for (int loop = 2; loop < loops + 1; loop++)
            {
                float from = (loop * clip.Duration) + (0.5f * clip.Duration);
                Add(clip.Name, steps, found.Where(f => f.Time >= from && f.Time < from + clip.Duration).Select(f => (ClipTime.Within(f.Time, clip.Duration, ClipEnd.Loops), f.Joint)), clip.Duration);
            }
        }
    }

    /// <inheritdoc/>
    public override string ToString()
    {
        var text = new StringBuilder();
        foreach ((string gait, Row row) in rows.Append(new KeyValuePair<string, Row>("all", All)))
        {
            text.AppendLine(row.Line(gait));
        }

        return text.ToString();
    }

    private void Add(string gait, ClipEvent[] steps, IEnumerable<(float Time, string Joint)> events, float duration)
    {
        var left = events.ToList();
        Row row = rows.GetValueOrDefault(gait);
        foreach (ClipEvent step in steps)
        {
            float Apart((float Time, string Joint) e) => Math.Min(Math.Abs(e.Time - step.Time), duration - Math.Abs(e.Time - step.Time));
            int best = -1;
            for (int i = 0; i < left.Count; i++)
            {
                best = left[i].Joint == step.Joint && Apart(left[i]) <= Near && (best < 0 || Apart(left[i]) < Apart(left[best])) ? i : best;
            }

            row += new Row(1, best >= 0 ? 1 : 0, 0, best >= 0 ? Apart(left[best]) : 0f);
            if (best >= 0)
            {
                left.RemoveAt(best);
            }
        }

        rows[gait] = row + new Row(0, 0, left.Count, 0f);
    }

    /// <summary>Counts of one gait.</summary>
    /// <param name="Steps">The animator's own.</param>
    /// <param name="Found">Of them, within <see cref="Near"/>.</param>
    /// <param name="False">Found where there is no step.</param>
    /// <param name="Apart">Sum of the distances in time of those found, seconds.</param>
    internal readonly record struct Row(int Steps, int Found, int False, float Apart)
    {
        /// <summary>As a line of a table.</summary>
        public string Line(string name) => FormattableString.Invariant($"| {name} | {Steps} | {100.0 * Found / Math.Max(1, Steps):0.0} % | {100.0 * False / Math.Max(1, Found + False):0.0} % | {1000 * Apart / Math.Max(1, Found):0} ms |");

        public static Row operator +(Row a, Row b) => new(a.Steps + b.Steps, a.Found + b.Found, a.False + b.False, a.Apart + b.Apart);
    }
}
