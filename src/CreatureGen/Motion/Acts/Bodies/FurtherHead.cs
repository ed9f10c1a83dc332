namespace CreatureGen.Motion.Acts.Bodies;

/// <summary>A head of a body that has more than one, on a neck of its own.</summary>
/// <param name="Neck">The neck's joints, lowest first.</param>
/// <param name="Head">The head's joint alone.</param>
/// <param name="Skin">The skin of both.</param>
/// <param name="Face">That of the head.</param>
internal sealed record FurtherHead(TurnedChain Neck, TurnedChain Head, BonePoints Skin, BonePoints Face);
