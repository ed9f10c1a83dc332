using System.Collections.Generic;
using System.Linq;
using CreatureGen.Motion.Acts.Library;

namespace CreatureGen.Motion;

/// <summary>The acts that come with the library. Several of one name are for different builds; of those a creature has the first that is for it.</summary>
public static class ActLibrary
{
    /// <summary>All, in the order in which they are listed.</summary>
    public static IReadOnlyList<Act> All { get; } = Attacks.All.Concat(Upkeep.All).Concat(Displays.All).Concat(Postures.All).ToArray();
}
