using UnityEngine;
using UnityEngine.Rendering.HighDefinition;

namespace FastPoints.Rendering.Hdrp
{
    // Draws the clouds in HDRP, before transparent meshes: a custom pass of all cameras, without a volume.
    internal sealed class HdrpPass : CustomPass
    {
        /// <summary>What HDRP draws until then by a depth that has no points in it (fog, volumetric clouds, water) would cover
        /// them.</summary>
        const CustomPassInjectionPoint InjectionPoint = CustomPassInjectionPoint.BeforeTransparent;

        static HdrpPass s_pass;

        // Works with domain reload off, too: adding twice adds once.
        [BeginsPass]
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        public static void Begin()
        {
            End();
            s_pass = new HdrpPass { name = "FastPoints" };
            CustomPassVolume.RegisterGlobalCustomPass(InjectionPoint, s_pass);
        }

        public static void End()
        {
            if (s_pass != null)
                CustomPassVolume.UnregisterGlobalCustomPass(InjectionPoint, s_pass);
            s_pass = null;
        }

        protected override void Execute(CustomPassContext ctx)
        {
            var scene = PointScene.Current;
            var camera = ctx.hdCamera.camera;
            if (scene == null || !PointScene.ShowsClouds(camera))
                return;
            bool isForHeadset = !camera.TryGetComponent<HDAdditionalCameraData>(out var data) || data.xrRendering;
            scene.AddView(camera, isForHeadset);
            bool hasBothEyes = isForHeadset && camera.stereoEnabled && ctx.cameraColorBuffer.rt.volumeDepth > 1;
            var target = CameraTarget.Of(camera, ctx.cameraColorBuffer, ctx.cameraDepthBuffer, hasBothEyes);
            if (!hasBothEyes)
                target.Eye = EyeOf(ctx.hdCamera);
            target.IsSubViewport = true;
            if (scene.IsLit)
                target.Light = SceneLights.OfSunWithoutIntensity();
            target.WidthPx = ctx.hdCamera.actualWidth;
            target.HeightPx = ctx.hdCamera.actualHeight;
            scene.Record(ctx.cmd, camera, target);
        }

        // With the jitter of HDRP's temporal anti-aliasing. Its matrix is the device's for a texture: of that the first two
        // rows are taken, and depth from the camera.
        static EyeMatrices EyeOf(HDCamera camera)
        {
            ref readonly var view = ref camera.mainViewConstants;
            var projection = camera.camera.projectionMatrix;
            projection.SetRow(0, view.projMatrix.GetRow(0));
            projection.SetRow(1, view.projMatrix.GetRow(1) * (SystemInfo.graphicsUVStartsAtTop ? -1 : 1));
            return EyeMatrices.Of(view.viewMatrix, projection, view.worldSpaceCameraPos);
        }
    }
}
