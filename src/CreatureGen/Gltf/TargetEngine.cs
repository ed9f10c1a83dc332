namespace CreatureGen.Gltf;

/// <summary>For whose importer a file with clips is written: they differ in what they tell a loop by, and in which extras they keep.</summary>
public enum TargetEngine
{
    /// <summary>Plain names; <c>loop</c>, <c>speed</c> and <c>events</c> in the extras of the animations, which three.js and Babylon.js keep.</summary>
    Generic,

    /// <summary>Godot: names of clips that loop end in <c>-loop</c>, which its importer takes off again; it drops extras of animations, so those of all clips are in the extras of the root joint as well, as <c>clips</c>.</summary>
    Godot,

    /// <summary>Unity (glTFast, UnityGLTF): extras of all clips on the root joint as well.</summary>
    Unity,

    /// <summary>Unreal Engine: extras of all clips on the root joint as well.</summary>
    Unreal,
}
