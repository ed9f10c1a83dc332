using System.Collections.Generic;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Events;

/// <summary>What a rule found in a clip.</summary>
/// <param name="Events">The moments in the order of time; the strength of each is its angular acceleration in thresholds.</param>
/// <param name="Curves">The curves of all joints of the rule.</param>
public sealed record AngularFinding(IReadOnlyList<ClipEvent> Events, IReadOnlyList<AngularCurve> Curves);
