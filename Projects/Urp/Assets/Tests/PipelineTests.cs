using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace FastPoints.Projects.Urp
{
    /// <summary>All that the package's tests say of this project, they say of this pipeline.</summary>
    [Category("Smoke")]
    public sealed class PipelineTests
    {
        [Test]
        public void Pipeline_OfThisProject_IsUrps() =>
            Assert.That(GraphicsSettings.currentRenderPipeline, Is.TypeOf<UniversalRenderPipelineAsset>());

        [Test]
        public void Colour_OfThisProject_IsLinear() => Assert.That(PlayerSettings.colorSpace, Is.EqualTo(ColorSpace.Linear));
    }
}
