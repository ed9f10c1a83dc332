using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling.Placement;

/// <summary>A fin where the rules put it: single on the midline, or a pair on the flanks.</summary>
/// <param name="Place">Back, belly or flanks.</param>
/// <param name="Style">Outline.</param>
/// <param name="Bone">Index of the measured bone that carries it.</param>
/// <param name="Socket">The cells it grows out of; their rows are its extent along the body.</param>
/// <param name="Scale">Its size; of a fin on the midline, the factor along the body is already in the rows.</param>
internal sealed record FinPlacement(FinPlace Place, FinStyle Style, int Bone, SocketBlueprint Socket, PartScale Scale);

/// <summary>The end of the tail.</summary>
/// <param name="Style">Outline.</param>
/// <param name="Scale">Its size.</param>
internal sealed record TailPlacement(TailStyle Style, PartScale Scale);

/// <summary>Where a swimmer's fins are.</summary>
/// <param name="Fins">Fins in the order in which they were placed.</param>
/// <param name="Tail">The tail.</param>
internal sealed record SwimmingPlacement(IReadOnlyList<FinPlacement> Fins, TailPlacement Tail);
