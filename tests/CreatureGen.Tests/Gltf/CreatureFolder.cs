using System;
using System.Collections.Generic;
using System.IO;

namespace CreatureGen.Tests.Gltf;

/// <summary>A temporary folder of creature files, which goes when the tests that share it are done.</summary>
public sealed class CreatureFolder : IDisposable
{
    public CreatureFolder()
    {
        Path = Directory.CreateTempSubdirectory("creaturegen-").FullName;
        Files = CreatureFiles.Write(Path);
    }

    public string Path { get; }

    internal IReadOnlyList<CreatureFile> Files { get; }

    public void Dispose() => Directory.Delete(Path, recursive: true);
}
