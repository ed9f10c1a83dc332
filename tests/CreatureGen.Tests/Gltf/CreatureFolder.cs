using System;
using System.Collections.Generic;
using System.IO;
using CreatureGen.Tests.Gltf;
using Xunit;

[assembly: AssemblyFixture(typeof(CreatureFolder))]

namespace CreatureGen.Tests.Gltf;

/// <summary>A temporary folder of creature files, written when a test first wants one; it goes when all tests are done.</summary>
public sealed class CreatureFolder : IDisposable
{
    private readonly Lazy<(string Path, IReadOnlyList<CreatureFile> Files)> content = new(() =>
    {
        string path = Directory.CreateTempSubdirectory("creaturegen-").FullName;
        return (path, CreatureFiles.Write(path));
    });

    public string Path => content.Value.Path;

    internal IReadOnlyList<CreatureFile> Files => content.Value.Files;

    public void Dispose()
    {
        if (content.IsValueCreated)
        {
            Directory.Delete(content.Value.Path, recursive: true);
        }
    }
}
