using System;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>Light and shade of the planes of a face in its coat: a pale bridge of the nose, dark troughs from the inner corners of the eyes along both sides of it, and pale cheekbones under them. In one tone the front of a head is a ball or a disc.</summary>
internal static class FaceShade
{
    // The bridge: the rings over which it begins and ends, counted from the eye, and half its breadth and that of its edge, radians around the head.
    private const float BridgeFrom = -7.5f;
    private const float BridgeTo = 0.6f;
    private const float BridgeFade = 2f;
    private const float BridgeBreadth = 0.4f;
    private const float BridgeEdge = 0.26f;

    // The trough: rings ahead of the eye at its ends, its middle at either of them relative to the eye's angle, half its breadth, radians, and the rings over which it begins and ends.
    private const float TroughFrom = 0.9f;
    private const float TroughTo = 5.5f;
    private const float TroughAtEye = 0.84f;
    private const float TroughAtNose = 0.72f;
    private const float TroughBreadth = 0.3f;
    private const float TroughFade = 1.4f;

    /// <summary>The part of a trough's half breadth that its edge takes.</summary>
    private const float TroughEdge = 0.8f;

    // The cheekbone: its middle, rings and radians from the eye, its half axes in them, and its light against that of the bridge.
    private const float CheekRing = -0.6f;
    private const float CheekBelow = 0.72f;
    private const float CheekLength = 3.2f;
    private const float CheekHeight = 0.42f;
    private const float CheekLight = 0.6f;

    /// <summary>How light a place is, -1..1, at a ring of the body and an angle around it (0 dorsal, π ventral), with eyes at others.</summary>
    public static float At(float ring, float around, float eyeRing, float eyeAround)
    {
        float from = ring - eyeRing;
        float bridge = Scalar.Smooth((BridgeBreadth - around) / BridgeEdge) * Scalar.Smooth((from - BridgeFrom) / BridgeFade) * Scalar.Smooth((BridgeTo - from) / BridgeFade);
        float ahead = Scalar.Clamp((-from - TroughFrom) / (TroughTo - TroughFrom), 0f, 1f);
        float off = Math.Abs(around - (eyeAround * Scalar.Lerp(TroughAtEye, TroughAtNose, ahead))) / TroughBreadth;
        float trough = Scalar.Smooth((1f - off) / TroughEdge) * Scalar.Smooth((TroughFade - TroughFrom - from) / TroughFade) * Scalar.Smooth((TroughTo + from) / TroughFade);
        float along = (from - CheekRing) / CheekLength;
        float below = (around - eyeAround - CheekBelow) / CheekHeight;
        float cheek = Scalar.Smooth(1f - (float)Math.Sqrt((along * along) + (below * below)));
        return bridge - trough + (CheekLight * cheek);
    }
}
