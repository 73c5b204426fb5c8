using FastPoints.Drawing;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    static class ShaderNames
    {
        public static readonly int AdditionalAxes = Shader.PropertyToID("_FastPointsAdditionalAxes");
        public static readonly int AdditionalColors = Shader.PropertyToID("_FastPointsAdditionalColors");
        public static readonly int AdditionalCount = Shader.PropertyToID("_FastPointsAdditionalCount");
        public static readonly int AdditionalPlaces = Shader.PropertyToID("_FastPointsAdditionalPlaces");
        public static readonly int Ambient = Shader.PropertyToID("_FastPointsAmbient");
        public static readonly int ArgumentsOut = Shader.PropertyToID("_FastPointsArgumentsOut");
        public static readonly int Bank = Shader.PropertyToID("_FastPointsBank");
        public static readonly int BankCount = Shader.PropertyToID("_FastPointsBankCount");
        public static readonly int BankNumber = Shader.PropertyToID("_FastPointsBankNumber");
        public static readonly int BankOut = Shader.PropertyToID("_FastPointsBankOut");
        public static readonly int Capacity = Shader.PropertyToID("_FastPointsCapacity");
        public static readonly int Carries = Shader.PropertyToID("_FastPointsCarries");
        public static readonly int Chosen = Shader.PropertyToID("_FastPointsChosen");
        public static readonly int ChosenOut = Shader.PropertyToID("_FastPointsChosenOut");
        public static readonly int ClipBoxCount = Shader.PropertyToID("_FastPointsClipBoxCount");
        public static readonly int ClipBoxesAt = Shader.PropertyToID("_FastPointsClipBoxesAt");
        public static readonly int CloudsAt = Shader.PropertyToID("_FastPointsCloudsAt");
        public static readonly int DepthToDevice = Shader.PropertyToID("_FastPointsDepthToDevice");
        public static readonly int EdlStrength = Shader.PropertyToID("_FastPointsEdlStrength");
        public static readonly int EffectOrigin = Shader.PropertyToID("_FastPointsEffectOrigin");
        public static readonly int EffectPointCount = Shader.PropertyToID("_FastPointsEffectPointCount");
        public static readonly int EffectPoints = Shader.PropertyToID("_FastPointsEffectPoints");
        public static readonly int EffectPointsOut = Shader.PropertyToID("_FastPointsEffectPointsOut");
        public static readonly int EyeOffset = Shader.PropertyToID("_FastPointsEyeOffset");
        public static readonly int FillsHoles = Shader.PropertyToID("_FastPointsFillsHoles");
        public static readonly int FirstInstance = Shader.PropertyToID("_FastPointsFirstInstance");
        public static readonly int FirstPage = Shader.PropertyToID("_FastPointsFirstPage");
        public static readonly int Flip = Shader.PropertyToID("_FastPointsFlip");
        public static readonly int Forward = Shader.PropertyToID("_FastPointsForward");
        public static readonly int ForwardClip = Shader.PropertyToID("_FastPointsForwardClip");
        public static readonly int GroupsPerRow = Shader.PropertyToID("_FastPointsGroupsPerRow");
        public static readonly int InstanceCount = Shader.PropertyToID("_FastPointsInstanceCount");
        public static readonly int IsLinear = Shader.PropertyToID("_FastPointsIsLinear");
        public static readonly int IsOrthographic = Shader.PropertyToID("_FastPointsIsOrthographic");
        public static readonly int KeptShare = Shader.PropertyToID("_FastPointsKeptShare");
        public static readonly int LastOfNodeAt = Shader.PropertyToID("_FastPointsLastOfNodeAt");
        public static readonly int LayerColor = Shader.PropertyToID("_FastPointsLayerColor");
        public static readonly int LayerDepth = Shader.PropertyToID("_FastPointsLayerDepth");
        public static readonly int LayerDevice = Shader.PropertyToID("_FastPointsLayerDevice");
        public static readonly int LayerNumbers = Shader.PropertyToID("_FastPointsLayerNumbers");
        public static readonly int LayerSums = Shader.PropertyToID("_FastPointsLayerSums");
        public static readonly int LightColor = Shader.PropertyToID("_FastPointsLightColor");
        public static readonly int LightDirection = Shader.PropertyToID("_FastPointsLightDirection");
        public static readonly int ListedPoints = Shader.PropertyToID("_FastPointsListedPoints");
        public static readonly int Lists = Shader.PropertyToID("_FastPointsLists");
        public static readonly int Masks = Shader.PropertyToID("_FastPointsMasks");
        public static readonly int MasksOut = Shader.PropertyToID("_FastPointsMasksOut");
        public static readonly int NodeOfInstanceAt = Shader.PropertyToID("_FastPointsNodeOfInstanceAt");
        public static readonly int NodesAt = Shader.PropertyToID("_FastPointsNodesAt");
        public static readonly int Pages = Shader.PropertyToID("_FastPointsPages");
        public static readonly int Pixels = Shader.PropertyToID("_FastPointsPixels");
        public static readonly int PixelsOut = Shader.PropertyToID("_FastPointsPixelsOut");
        public static readonly int PixelPositions = Shader.PropertyToID("_FastPointsPixelPositions");
        public static readonly int PointsPerFrame = Shader.PropertyToID("_FastPointsPointsPerFrame");
        public static readonly int RightEyeOffset = Shader.PropertyToID("_FastPointsRightEyeOffset");
        public static readonly int RightForward = Shader.PropertyToID("_FastPointsRightForward");
        public static readonly int RightViewProjection = Shader.PropertyToID("_FastPointsRightViewProjection");
        public static readonly int ScalePx = Shader.PropertyToID("_FastPointsScalePx");
        public static readonly int ScreenPx = Shader.PropertyToID("_FastPointsScreenPx");
        public static readonly int Shadow = Shader.PropertyToID("_FastPointsShadow");
        public static readonly int ShadowPixels = Shader.PropertyToID("_FastPointsShadowPixels");
        public static readonly int Size = Shader.PropertyToID("_FastPointsSize");
        public static readonly int SizeLimitsPx = Shader.PropertyToID("_FastPointsSizeLimitsPx");
        public static readonly int SizeNodesAt = Shader.PropertyToID("_FastPointsSizeNodesAt");
        public static readonly int Staging = Shader.PropertyToID("_FastPointsStaging");
        public static readonly int VerticesPerBlock = Shader.PropertyToID("_FastPointsVerticesPerBlock");
        public static readonly int ViewProjection = Shader.PropertyToID("_FastPointsViewProjection");
        public static readonly int VisibleAt = Shader.PropertyToID("_FastPointsVisibleAt");

        public const string GatherPointsKernel = "FastPointsGatherPoints";
        public const string CopyPagesKernel = "FastPointsCopyPages";
        public const string ClearPixelsKernel = "FastPointsClearPixels";
        public const string RasterDepthKernel = "FastPointsRasterDepth";
        public const string RasterColorKernel = "FastPointsRasterColor";
        public const string RasterNumberKernel = "FastPointsRasterNumber";
        public const string CountVisibleKernel = "FastPointsCountVisible";
        public const string PlanFrameKernel = "FastPointsPlanFrame";
        public const string ListVisibleKernel = "FastPointsListVisible";
        public const string MarkPixelsKernel = "FastPointsMarkPixels";
        public const string MarkTexelsKernel = "FastPointsMarkTexels";
        public const string AdaptiveKeyword = "FASTPOINTS_ADAPTIVE";
        public const string BlendedKeyword = "FASTPOINTS_BLENDED";
        public const string ClippedKeyword = "FASTPOINTS_CLIPPED";
        public const string FilteredKeyword = "FASTPOINTS_FILTERED";
        public const string FromPixelsKeyword = "FASTPOINTS_FROM_PIXELS";
        public const string LayeredKeyword = "FASTPOINTS_LAYERED";
        public const string LitKeyword = "FASTPOINTS_LIT";
        public const string ShadowedKeyword = "FASTPOINTS_SHADOWED";
        public const string StereoKeyword = "FASTPOINTS_STEREO";
        public const string SquaresKeyword = "FASTPOINTS_SQUARES";
        public const string DiscsKeyword = "FASTPOINTS_DISCS";
        public const string ParaboloidsKeyword = "FASTPOINTS_PARABOLOIDS";
    }

    static class ShaderValues
    {
        public static void SetPixelPositions(MaterialPropertyBlock properties, in PixelPositions positions) =>
            properties.SetMatrix(ShaderNames.PixelPositions, RowsOf(VectorOf(positions.First), VectorOf(positions.StepX),
                VectorOf(positions.StepY), VectorOf(positions.Forward)));

        public static void SetLight(MaterialPropertyBlock properties, in PointLighting light)
        {
            properties.SetMatrix(ShaderNames.Ambient, AmbientOf(light));
            properties.SetVector(ShaderNames.LightDirection, VectorOf(light.Direction));
            properties.SetVector(ShaderNames.LightColor, VectorOf(light.Color));
            properties.SetInteger(ShaderNames.AdditionalCount, light.AdditionalCount);
            if (light.AdditionalCount == 0)
                return;
            properties.SetMatrix(ShaderNames.AdditionalPlaces, PlacesOf(light));
            properties.SetMatrix(ShaderNames.AdditionalColors, ColorsOf(light));
            properties.SetMatrix(ShaderNames.AdditionalAxes, AxesOf(light));
        }

        public static void SetLight(CommandBuffer commands, ComputeShader shader, in PointLighting light)
        {
            commands.SetComputeMatrixParam(shader, ShaderNames.Ambient, AmbientOf(light));
            commands.SetComputeVectorParam(shader, ShaderNames.LightDirection, VectorOf(light.Direction));
            commands.SetComputeVectorParam(shader, ShaderNames.LightColor, VectorOf(light.Color));
            commands.SetComputeIntParam(shader, ShaderNames.AdditionalCount, light.AdditionalCount);
            commands.SetComputeMatrixParam(shader, ShaderNames.AdditionalPlaces, PlacesOf(light));
            commands.SetComputeMatrixParam(shader, ShaderNames.AdditionalColors, ColorsOf(light));
            commands.SetComputeMatrixParam(shader, ShaderNames.AdditionalAxes, AxesOf(light));
        }

        static Matrix4x4 AmbientOf(in PointLighting light) => RowsOf(VectorOf(light.AmbientX), VectorOf(light.AmbientY),
            VectorOf(light.AmbientZ), VectorOf(light.AmbientAll));

        static Matrix4x4 PlacesOf(in PointLighting light) => RowsOf(
            VectorOf(light.Light0.PositionOrDirection, light.Light0.ConeOffset),
            VectorOf(light.Light1.PositionOrDirection, light.Light1.ConeOffset),
            VectorOf(light.Light2.PositionOrDirection, light.Light2.ConeOffset),
            VectorOf(light.Light3.PositionOrDirection, light.Light3.ConeOffset));

        static Matrix4x4 ColorsOf(in PointLighting light) => RowsOf(VectorOf(light.Light0.Color, light.Light0.OneOverRangeSq),
            VectorOf(light.Light1.Color, light.Light1.OneOverRangeSq), VectorOf(light.Light2.Color, light.Light2.OneOverRangeSq),
            VectorOf(light.Light3.Color, light.Light3.OneOverRangeSq));

        static Matrix4x4 AxesOf(in PointLighting light) => RowsOf(
            VectorOf(light.Light0.AxisToLight, light.Light0.ConeScale),
            VectorOf(light.Light1.AxisToLight, light.Light1.ConeScale),
            VectorOf(light.Light2.AxisToLight, light.Light2.ConeScale),
            VectorOf(light.Light3.AxisToLight, light.Light3.ConeScale));

        public static Vector4 VectorOf(float3 value, float w = 0) => new Vector4(value.x, value.y, value.z, w);

        public static Matrix4x4 RowsOf(Vector4 row0, Vector4 row1, Vector4 row2, Vector4 row3)
        {
            var rows = new Matrix4x4();
            rows.SetRow(0, row0);
            rows.SetRow(1, row1);
            rows.SetRow(2, row2);
            rows.SetRow(3, row3);
            return rows;
        }
    }
}
